package org.evoloop.statechart;

import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.evoloop.statemachine.Names;
import org.jspecify.annotations.Nullable;

/**
 * Keywords in guillemets beside the name of an element (UML 2.5.1, annex C): {@code «device StopUp» Gap}. Two angle
 * brackets on each side are also accepted. A keyword that is not understood stays in the name, where it is found again.
 */
final class Keywords {
    /** A keyword with all that belongs to it. */
    static final Pattern GROUP = Pattern.compile("(?:«|<<)\\s*([^«»]*?)\\s*(?:»|>>)");

    private static final Pattern OPEN = Pattern.compile("\\s*(?:«|<<).*", Pattern.DOTALL);
    private static final Pattern WORD = Pattern.compile("\\p{L}*");

    /** What can be written at a state, and at an event. */
    private static final List<String> OF_STATES = List.of(DeviceUse.DEVICE, DeviceUse.SENDS);

    private static final List<String> OF_EVENTS = List.of(EventKeywords.SPONTANEOUS, EventKeywords.URGENT);

    private Keywords() {}

    /** Whether there may be a keyword; nearly all names have none. */
    static boolean isPossible(String name) {
        return name.indexOf('«') >= 0 || name.contains("<<");
    }

    /** Whether the name of a state, or of something else that is drawn, still has a keyword. */
    static boolean isInName(String name) {
        return isPossible(name)
                && (OPEN.matcher(name).matches() || GROUP.matcher(name).find());
    }

    /** Whether an event's name still begins with a keyword; in the middle it may have anything, such as a condition. */
    static boolean isBeforeEvent(String name) {
        return isPossible(name) && OPEN.matcher(name).matches();
    }

    /**
     * What is wrong with the keyword that is still in a name.
     *
     * @param what the element, for messages
     * @param ofState whether it is a state
     */
    static Problem problem(Place place, String what, String name, boolean ofState) {
        Matcher group = GROUP.matcher(name);
        if (!group.find()) {
            return new Problem(place, what + " has a keyword without an end", "write » or >> after it");
        }
        return wrong(place, what, "keyword", group.group(1), ofState ? OF_STATES : OF_EVENTS);
    }

    /**
     * What is wrong with the invariant of a state; null if it is not meant as a keyword.
     *
     * @param text that {@link DeviceUse#parse} does not understand
     */
    static @Nullable Problem misspelt(Place place, String what, String text) {
        String word = word(text);
        return OF_STATES.stream().anyMatch(known -> isNear(word, known))
                ? wrong(place, what, "invariant", text, OF_STATES)
                : null;
    }

    /** In free text, another first letter makes another word: "service running" is no misspelt "device". */
    private static boolean isNear(String word, String known) {
        return word.startsWith(known.substring(0, 1))
                && (word.equals(known) || !Names.meant(word, List.of(known)).isEmpty());
    }

    private static Problem wrong(Place place, String what, String kind, String text, List<String> known) {
        String word = word(text);
        String forms =
                known == OF_STATES ? "«device STATE» or «sends EVENT, EVENT»" : "«spontaneous» EVENT or «urgent» EVENT";
        boolean second = known == OF_STATES && DeviceUse.parse(text).isPresent();
        boolean right = known.contains(word);
        String meant = right ? "" : Names.meant(word, known);
        return new Problem(
                place,
                what + " has " + (second ? "a second device state, " : right ? "the incomplete " : "the unknown ")
                        + (second ? "" : kind + " ") + "'" + Names.shown(text) + "'",
                second ? "keep one" : meant.isEmpty() ? "write " + forms : meant.substring(2));
    }

    private static String word(String text) {
        Matcher word = WORD.matcher(text);
        return word.lookingAt() ? word.group() : "";
    }
}
