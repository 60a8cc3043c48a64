package org.evoloop.statechart;

import java.util.ArrayList;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.StateMachine;

/**
 * The keywords in guillemets (UML 2.5.1, annex C) before the name of an event: {@code «spontaneous» endSpot}, which the
 * device raises itself, {@code «urgent» fire}, which waits for nothing, or both, as {@code «spontaneous» «urgent» fire} or {@code «spontaneous, urgent» fire}. Two
 * angle brackets on each side are also accepted.
 *
 * @since 0.1
 */
public final class EventKeywords {
    /** The keyword of an event that the device raises by itself. */
    public static final String SPONTANEOUS = "spontaneous";

    /** The keyword of an event that waits for nothing. */
    public static final String URGENT = "urgent";

    private static final String WORD = "(?:" + SPONTANEOUS + "|" + URGENT + ")";
    private static final String GROUP = "\\s*(?:«|<<)\\s*" + WORD + "(?:\\s*,\\s*" + WORD + ")*\\s*(?:»|>>)";
    private static final Pattern MARKED = Pattern.compile("((?:" + GROUP + ")+)\\s*(.*)");

    private EventKeywords() {}

    /** What is written before the name of such an event, with a space behind it; empty if it is neither. */
    public static String before(boolean spontaneous, boolean urgent) {
        return (spontaneous ? "«" + SPONTANEOUS + "» " : "") + (urgent ? "«" + URGENT + "» " : "");
    }

    /** The name of {@code trigger} with the keywords that it has in {@code machine}. */
    public static String drawn(StateMachine machine, Event trigger) {
        return before(machine.spontaneous().contains(trigger), machine.urgent().contains(trigger)) + trigger.name();
    }

    /** The name without the keywords, if it has any. */
    public static String unmarked(String name) {
        Matcher marked = MARKED.matcher(name);
        return marked.matches() ? marked.group(2) : name;
    }

    static List<String> unmarked(List<String> names) {
        return isAnyPossible(names)
                ? names.stream().map(EventKeywords::unmarked).toList()
                : List.copyOf(names);
    }

    /** The names that have the keyword, without it. */
    public static List<String> marked(List<String> names, String keyword) {
        if (!isAnyPossible(names)) {
            return List.of();
        }
        List<String> found = new ArrayList<>();
        for (String name : names) {
            Matcher marked = MARKED.matcher(name);
            if (marked.matches() && marked.group(1).contains(keyword)) {
                found.add(marked.group(2));
            }
        }
        return found;
    }

    /** Rare; avoids creating a list for each of a hundred thousand transitions. */
    private static boolean isAnyPossible(List<String> names) {
        for (int i = 0; i < names.size(); i++) {
            if (Keywords.isPossible(names.get(i))) {
                return true;
            }
        }
        return false;
    }
}
