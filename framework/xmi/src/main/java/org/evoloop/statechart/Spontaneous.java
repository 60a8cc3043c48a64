package org.evoloop.statechart;

import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * The keyword in guillemets (UML 2.5.1, annex C) before the name of an event that the device raises itself: {@code
 * «spontaneous» endSpot}. Two angle brackets on each side are also accepted.
 *
 * @since 0.1
 */
public final class Spontaneous {
    static final String KEYWORD = "spontaneous";
    private static final Pattern MARKED = Pattern.compile("\\s*(?:«|<<)\\s*" + KEYWORD + "\\s*(?:»|>>)\\s*(.*)");

    private Spontaneous() {}

    /** The name, preceded by the keyword. */
    public static String mark(String name) {
        return "«" + KEYWORD + "» " + name;
    }

    static boolean isMarked(String name) {
        return name.contains(KEYWORD) && MARKED.matcher(name).matches();
    }

    /** The name without the keyword, if it has one. */
    static String unmarked(String name) {
        Matcher marked = MARKED.matcher(name);
        return marked.matches() ? marked.group(1) : name;
    }

    static List<String> unmarked(List<String> names) {
        return anyIsMarked(names) ? names.stream().map(Spontaneous::unmarked).toList() : List.copyOf(names);
    }

    /** The names that have the keyword, without it. */
    static List<String> marked(List<String> names) {
        return anyIsMarked(names)
                ? names.stream()
                        .filter(Spontaneous::isMarked)
                        .map(Spontaneous::unmarked)
                        .toList()
                : List.of();
    }

    /** Rare; avoids creating a list for each of a hundred thousand transitions. */
    private static boolean anyIsMarked(List<String> names) {
        for (int i = 0; i < names.size(); i++) {
            if (isMarked(names.get(i))) {
                return true;
            }
        }
        return false;
    }
}
