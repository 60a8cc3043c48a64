package org.evoloop.device.file;

import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;

/**
 * A part of a file, as it is written.
 *
 * <p>Threading: immutable.
 *
 * @since 0.1
 */
public sealed interface Node {
    /** The line on which it begins, from 1. */
    int line();

    /**
     * A text; never evaluated, so {@code 08:00} and {@code off} are what they look like.
     *
     * @param plain whether it is written without quotes
     */
    record Text(int line, String value, boolean plain) implements Node {
        /** Whether nothing is written. */
        public boolean isMissing() {
            return plain && value.matches("|~|null|Null|NULL");
        }

        @Override
        public String toString() {
            return value;
        }
    }

    /** A list. */
    record Items(int line, List<Node> items) implements Node {
        public Items {
            items = List.copyOf(items);
        }
    }

    /**
     * A mapping, in the order of the file.
     *
     * @param entries by key, of which each is there once
     */
    record Entries(int line, Map<Text, Node> entries) implements Node {
        public Entries {
            entries = Collections.unmodifiableMap(new LinkedHashMap<>(entries));
        }
    }

    /** What is written, without its place: equal for two parts that say the same. */
    default String content() {
        if (this instanceof Entries mapping) {
            return mapping.entries().entrySet().stream()
                    .map(entry ->
                            entry.getKey().content() + ": " + entry.getValue().content())
                    .collect(Collectors.joining(", ", "{", "}"));
        }
        return this instanceof Items list
                ? list.items().stream().map(Node::content).collect(Collectors.joining(", ", "[", "]"))
                : "'" + this + "'";
    }

    /** For messages. */
    default String kind() {
        return this instanceof Entries ? "a mapping" : this instanceof Items ? "a list" : "a text";
    }
}
