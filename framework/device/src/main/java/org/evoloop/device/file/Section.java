package org.evoloop.device.file;

import java.nio.file.Path;
import java.time.Duration;
import java.time.LocalTime;
import java.time.format.DateTimeParseException;
import java.util.ArrayList;
import java.util.Collection;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.NoSuchElementException;
import java.util.Optional;
import java.util.Set;
import java.util.function.Function;
import java.util.regex.Pattern;
import java.util.regex.PatternSyntaxException;
import java.util.stream.Collectors;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.ModelException;
import org.evoloop.statemachine.Names;
import org.jspecify.annotations.Nullable;

/**
 * A mapping of a device file while it is read. What is missing or cannot be used is noted with its line and left out, so
 * that all mistakes are found; {@link #done} notes the keys that nobody asked for.
 *
 * <p>Threading: for one thread.
 *
 * @since 0.1
 */
public final class Section {
    private static final String HOW_LONG = "write a number and a unit, such as 500 ms, 10 s, 5 min or 2 h";

    private final String name;
    private final Node.Entries node;
    private final Problems problems;
    private final Set<String> asked = new LinkedHashSet<>();

    /**
     * @param name for messages, such as {@code connections.fan}
     * @param problems receives the mistakes
     */
    public Section(String name, Node.Entries node, Problems problems) {
        this.name = name;
        this.node = node;
        this.problems = problems;
    }

    /**
     * The file as a section.
     *
     * @throws DeviceFileException if it cannot be read as sections
     */
    public static Section read(Path file, Problems problems) {
        return new Section("", Yaml.read(file, problems), problems);
    }

    /** As {@link #read}, of this text. */
    public static Section parse(String text, Problems problems) {
        return new Section("", Yaml.parse(text, problems), problems);
    }

    /** For messages. */
    public String name() {
        return name;
    }

    /** Where its mistakes go. */
    public Problems problems() {
        return problems;
    }

    /** The whole of it. */
    public Node.Entries node() {
        return node;
    }

    /** Its keys, in the order of the file. */
    public List<Node.Text> keys() {
        return List.copyOf(node.entries().keySet());
    }

    /** Whether it has this key. */
    public boolean has(String key) {
        return find(key) != null;
    }

    /** Whether it names an event, and none of the forms of messages that mean it: then any message does. */
    public boolean meansAnyMessage() {
        return has("event") && !has("values") && !has("pattern") && !has("ranges");
    }

    private @Nullable Node find(String key) {
        asked.add(key);
        for (Map.Entry<Node.Text, Node> entry : node.entries().entrySet()) {
            if (entry.getKey().value().equals(key)) {
                return entry.getValue();
            }
        }
        return null;
    }

    /** Notes a mistake that concerns the section as a whole. */
    public void problem(String mistake) {
        problems.at(node, mistake);
    }

    /** The value of {@code key}, whatever it is. */
    public Optional<Node> any(String key) {
        return Optional.ofNullable(find(key));
    }

    /** The text of {@code key}; empty if it is missing or no text. */
    public Optional<Node.Text> text(String key) {
        return any(key).flatMap(found -> text(key, found));
    }

    private Optional<Node.Text> text(String what, Node found) {
        if (found instanceof Node.Text text && !text.isMissing()) {
            return Optional.of(text);
        }
        problems.at(
                found,
                found instanceof Node.Text
                        ? what + " has no value; write one (in quotes if it begins with #), or leave the line out"
                        : what + " is " + found.kind() + ", but takes one text");
        return Optional.empty();
    }

    /** As {@link #text}; that it is missing is a mistake. */
    public Optional<Node.Text> need(String key) {
        require(key);
        return text(key);
    }

    /** Notes it as a mistake if {@code key} is missing. */
    public void require(String key) {
        if (!has(key)) {
            problem((name.isEmpty() ? "the file" : name) + " needs " + key);
        }
    }

    /** The texts of {@code key}: one, or a list of them. */
    public List<Node.Text> texts(String key) {
        Node found = find(key);
        List<Node> items = found == null ? List.of() : found instanceof Node.Items list ? list.items() : List.of(found);
        return items.stream().flatMap(item -> text(key, item).stream()).toList();
    }

    /** A text that {@code read} makes something of; its {@link IllegalArgumentException} is a mistake in that line. */
    public <T> Optional<T> value(String key, Function<String, T> read) {
        return text(key).flatMap(text -> {
            try {
                return Optional.of(read.apply(text.value()));
            } catch (IllegalArgumentException refused) {
                problems.at(text, key + ": " + refused.getMessage());
                return Optional.empty();
            }
        });
    }

    /** A duration, such as {@code 500 ms} or {@code 10 s}. */
    public Optional<Duration> duration(String key) {
        return value(key, Section::time);
    }

    private static Duration time(String text) {
        try {
            return new Event("tm(" + text + ")").timeTrigger().orElseThrow();
        } catch (ModelException | NoSuchElementException wrong) {
            throw new IllegalArgumentException("'" + Names.inOneLine(text) + "' is no duration; " + HOW_LONG);
        }
    }

    /** A regular expression. */
    public Optional<Pattern> pattern(String key) {
        return value(key, text -> {
            try {
                return Pattern.compile(text);
            } catch (PatternSyntaxException wrong) {
                throw new IllegalArgumentException("'" + text + "' is no regular expression: " + wrong.getDescription()
                        + " at character " + (wrong.getIndex() + 1));
            }
        });
    }

    /** A whole number in this range. */
    public Optional<Integer> number(String key, int least, int most) {
        return value(key, text -> {
            if (!text.matches("[0-9]{1,9}") || Integer.parseInt(text) < least || Integer.parseInt(text) > most) {
                throw new IllegalArgumentException("'" + text + "' is no whole number from " + least + " to " + most);
            }
            return Integer.parseInt(text);
        });
    }

    /** A duration of more than nothing. */
    public Optional<Duration> period(String key) {
        Optional<Duration> time = duration(key);
        if (time.isPresent() && time.get().isZero()) {
            problem(path(key) + " is no time at all; give more than 0 s");
        }
        return time;
    }

    /**
     * A time of day.
     *
     * @throws IllegalArgumentException if the text is none
     */
    public static LocalTime timeOfDay(String text) {
        try {
            return LocalTime.parse(text);
        } catch (DateTimeParseException wrong) {
            throw new IllegalArgumentException("'" + text + "' is no time of day; write it as 07:30");
        }
    }

    /** Two times of day between which something holds; none if {@code key} is missing, or has something else. */
    public List<LocalTime> between(String key) {
        List<Node.Text> texts = texts(key);
        List<LocalTime> times = new ArrayList<>();
        for (Node.Text text : texts) {
            try {
                times.add(timeOfDay(text.value()));
            } catch (IllegalArgumentException wrong) {
                problems.at(text, String.valueOf(wrong.getMessage()));
            }
        }
        if (has(key) && texts.size() != 2) {
            problem(path(key) + " takes two times of day, such as [\"22:00\", \"06:00\"]");
        }
        return texts.size() == 2 && times.size() == 2 ? times : List.of();
    }

    /** The one of {@code keys} that is there; none and more than one are mistakes. */
    public Optional<String> oneOf(Collection<String> keys) {
        return oneOf(keys, "");
    }

    /** As {@link #oneOf(Collection)}, with {@code hint} behind the mistake. */
    public Optional<String> oneOf(Collection<String> keys, String hint) {
        List<String> given = keys.stream().filter(this::has).toList();
        if (given.size() == 1) {
            return Optional.of(given.get(0));
        }
        problem(name + " needs " + (given.isEmpty() ? "one" : "only one") + " of " + String.join(", ", keys) + hint);
        return Optional.empty();
    }

    /** {@code true} or {@code false}. */
    public Optional<Boolean> flag(String key) {
        return value(key, text -> {
            if (!text.equals("true") && !text.equals("false")) {
                throw new IllegalArgumentException("'" + text + "' is neither true nor false");
            }
            return text.equals("true");
        });
    }

    /** A mapping of texts to texts, in the order of the file. */
    public Map<Node.Text, Node.Text> pairs(String key) {
        Node found = find(key);
        return found == null ? Map.of() : pairs(key, found);
    }

    private Map<Node.Text, Node.Text> pairs(String what, Node found) {
        if (!(found instanceof Node.Entries entries)) {
            problems.at(found, what + " is " + found.kind() + ", but takes pairs, such as {TEXT: NAME}");
            return Map.of();
        }
        Map<Node.Text, Node.Text> pairs = new LinkedHashMap<>();
        entries.entries().forEach((left, right) -> text(left.value(), right).ifPresent(text -> pairs.put(left, text)));
        return pairs;
    }

    /** The section {@code key}; empty if it is missing or no mapping. */
    public Optional<Section> section(String key) {
        return any(key).flatMap(found -> section(key, found));
    }

    private Optional<Section> section(String key, Node found) {
        if (found instanceof Node.Entries entries) {
            return Optional.of(new Section(path(key), entries, problems));
        }
        boolean isEmpty = found instanceof Node.Text text && text.isMissing();
        problems.at(
                found,
                path(key)
                        + (isEmpty ? " is empty; leave it out, or give it" : " is " + found.kind() + ", but takes")
                        + " keys with values, such as {KEY: VALUE}");
        return Optional.empty();
    }

    private String path(String key) {
        return name.isEmpty() ? key : name + "." + key;
    }

    /** The sections in the section {@code key}, by their names. */
    public Map<Node.Text, Section> named(String key) {
        Map<Node.Text, Section> named = new LinkedHashMap<>();
        section(key)
                .ifPresent(all -> all.node
                        .entries()
                        .forEach((each, found) ->
                                all.section(each.value(), found).ifPresent(section -> named.put(each, section))));
        return named;
    }

    /** The sections in the list {@code key}, which may also be one section. */
    public List<Section> listed(String key) {
        Node found = find(key);
        if (found == null) {
            return List.of();
        }
        List<Node> items = found instanceof Node.Items list ? list.items() : List.of(found);
        List<Section> sections = new ArrayList<>();
        for (Node item : items) {
            section(key, item).ifPresent(sections::add);
        }
        return sections;
    }

    /** Notes each key that nobody has asked for, with the nearest one that is known. */
    public void done() {
        for (Node.Text key : node.entries().keySet()) {
            if (!asked.contains(key.value())) {
                problems.at(
                        key,
                        "'" + Names.inOneLine(key.value()) + "' is not known"
                                + (name.isEmpty() ? "" : " in " + name)
                                + Names.hint(key.value(), asked));
            }
        }
    }

    /** For messages. */
    @Override
    public String toString() {
        return node.entries().keySet().stream().map(Node.Text::value).collect(Collectors.joining(", ", "{", "}"));
    }
}
