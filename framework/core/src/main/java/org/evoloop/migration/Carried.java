package org.evoloop.migration;

import java.util.Locale;

/**
 * What becomes of a timer or a function.
 *
 * <p>Threading: immutable.
 *
 * @param name of a timer's event; of a function's do activity, or its state where no activity is drawn
 * @param becomes what it is called in the next model; the same as {@code name} unless a mapping says otherwise
 * @since 0.1
 */
public record Carried(Part part, String name, String becomes, How how) {
    /** What it is. */
    public enum Part {
        /** An event that is raised by itself in a state. */
        TIMER,
        /** What runs in a new state. */
        FUNCTION
    }

    /** What becomes of it. */
    public enum How {
        /** It goes on: a timer with what is left of its time. */
        KEPT,
        /** It ends and begins anew. */
        RESTARTED,
        /** It ends. */
        ENDED,
        /** It begins. */
        STARTED
    }

    /** For messages: {@code timer tm(2s) kept}, {@code timer tm(2s) kept as tm(3s)}. */
    @Override
    public String toString() {
        String as = name.equals(becomes) ? "" : " as " + becomes;
        return words(part) + " " + name + " " + words(how) + as;
    }

    private static String words(Enum<?> constant) {
        return constant.name().toLowerCase(Locale.ROOT);
    }
}
