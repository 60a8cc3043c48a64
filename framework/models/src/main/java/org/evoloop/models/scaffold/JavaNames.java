package org.evoloop.models.scaffold;

import java.util.HashSet;
import java.util.Locale;
import java.util.Set;

/**
 * Java names made from the names of a model, which may hold anything. Names are ASCII, since not every machine can have
 * files with other names, and differ in more than capital letters.
 *
 * <p>Threading: not thread-safe; it remembers the names that are taken.
 */
final class JavaNames {
    private final Set<String> taken = new HashSet<>();

    /** Takes a name, so that none is made up that is like it. */
    JavaNames reserve(String name) {
        taken.add(name.toLowerCase(Locale.ROOT));
        return this;
    }

    /**
     * A name that is free.
     *
     * @param core made by {@link #camel}, maybe with more around it
     */
    String free(String core) {
        String name = core;
        for (int number = 2; !taken.add(name.toLowerCase(Locale.ROOT)); number++) {
            name = core + number;
        }
        return name;
    }

    /**
     * The letters and digits of {@code text}, each word with a capital letter, as a part of a Java name.
     *
     * @param otherwise what to say of a text of which nothing is left
     */
    static String camel(String text, String otherwise) {
        StringBuilder name = new StringBuilder();
        boolean capital = true;
        for (int i = 0; i < text.length(); i++) {
            char next = text.charAt(i);
            if (next < 128 && Character.isLetterOrDigit(next)) {
                name.append(capital ? Character.toUpperCase(next) : next);
                capital = false;
            } else {
                capital = true;
            }
        }
        if (name.isEmpty()) {
            return otherwise;
        }
        return Character.isDigit(name.charAt(0)) ? otherwise + name : name.toString();
    }

    /** The same with a small first letter. */
    static String small(String camel) {
        return Character.toLowerCase(camel.charAt(0)) + camel.substring(1);
    }
}
