package org.evoloop.models.scaffold;

import java.util.HashSet;
import java.util.Locale;
import java.util.Set;

/**
 * Makes Java names from a model's names, which may contain any character. Names are ASCII, since not every file system
 * supports others, and never differ only in case.
 *
 * <p>Threading: not thread-safe; it remembers the names in use.
 */
final class JavaNames {
    private final Set<String> taken = new HashSet<>();

    /** Marks a name as used, so that none like it is made. */
    JavaNames reserve(String name) {
        taken.add(name.toLowerCase(Locale.ROOT));
        return this;
    }

    /**
     * An unused name.
     *
     * @param core made by {@link #camel}, possibly with a prefix or suffix
     */
    String free(String core) {
        String name = core;
        for (int number = 2; !taken.add(name.toLowerCase(Locale.ROOT)); number++) {
            name = core + number;
        }
        return name;
    }

    /**
     * The letters and digits of {@code text} as part of a Java name, each word with a capital letter.
     *
     * @param otherwise the name if no letter or digit is left
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

    /** The same name with a lower-case first letter. */
    static String small(String camel) {
        return Character.toLowerCase(camel.charAt(0)) + camel.substring(1);
    }
}
