package org.evoloop.learn;

import java.time.Duration;
import java.util.List;

/**
 * What was heard of a device after an input.
 *
 * <p>Threading: immutable.
 *
 * @param reply how it took the input
 * @param acts what it did by itself, in order
 * @param shown the state that it reports, or the class of its readings; empty if it shows nothing
 * @param after when a wait ended by an act or a change: how long the device had been as it was; else zero
 * @since 0.1
 */
public record Heard(Reply reply, List<String> acts, String shown, Duration after) {
    /** How a device took an input. */
    public enum Reply {
        /** It obeyed, or gave no sign that it did not. */
        ACCEPTED,
        /** It said that it does not obey. */
        REFUSED,
        /** It should have answered, and did not. */
        UNANSWERED,
        /** Nothing happened in a wait. */
        SILENT,
        /** A rule forbids the input here; it was not sent. */
        FORBIDDEN
    }

    public Heard {
        acts = List.copyOf(acts);
    }

    /** An input that was taken, after which the device shows {@code shown}. */
    public static Heard accepted(String shown) {
        return new Heard(Reply.ACCEPTED, List.of(), shown, Duration.ZERO);
    }

    /** A wait in which nothing happened. */
    public static Heard silent(String shown) {
        return new Heard(Reply.SILENT, List.of(), shown, Duration.ZERO);
    }

    /** Whether the device is known to be as it was before the input. */
    boolean leavesItAlone() {
        return reply == Reply.SILENT || reply == Reply.FORBIDDEN;
    }

    /** All of it but the time: what makes two answers the same. */
    String output() {
        return switch (reply) {
            case SILENT -> "nothing";
            case FORBIDDEN -> "forbidden";
            default ->
                (reply == Reply.ACCEPTED ? "" : reply.name().toLowerCase(java.util.Locale.ROOT) + " ")
                        + String.join(" ", acts) + ">" + shown;
        };
    }
}
