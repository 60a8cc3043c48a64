package org.evoloop.migration;

import java.util.Locale;

/**
 * The fate of a timer or a function.
 *
 * <p>Threading: immutable.
 *
 * @param name the timer's event; or the function's do activity, or its state where no activity is drawn
 * @param becomes its name in the next model; the same as {@code name} unless a mapping says otherwise
 * @since 0.1
 */
public record Carried(What part, String name, String becomes, How how) {
    /** The kind of part. */
    public enum What {
        /** A timer event of a state. */
        TIMER,
        /** The function of a new state. */
        FUNCTION
    }

    /** How it is carried over. */
    public enum How {
        /** It continues: a timer with its remaining time. */
        KEPT,
        /** It ends and starts again. */
        RESTARTED,
        /** It ends. */
        ENDED,
        /** It starts. */
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
