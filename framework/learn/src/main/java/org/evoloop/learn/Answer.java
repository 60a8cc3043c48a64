package org.evoloop.learn;

import static java.util.Objects.requireNonNull;

import java.util.List;

/**
 * What a device answered to an input, and what it did until it was quiet. Two equal answers mean that nobody could tell
 * the difference, so nothing that varies, such as a time, is part of one.
 *
 * <p>Threading: immutable.
 *
 * @param reply how it took the input
 * @param acts the names of the events by which it changed of its own accord, in order
 * @param shows the state that it reports in the end, or the class of its readings
 * @since 0.1
 */
public record Answer(Reply reply, List<String> acts, String shows) {
    public Answer {
        requireNonNull(reply, "the reply of an answer is null");
        acts = List.copyOf(acts);
        if (shows.isBlank()) {
            throw new IllegalArgumentException("what a device shows needs a name, also if it shows nothing");
        }
    }

    /** An answer without acts. */
    public Answer(Reply reply, String shows) {
        this(reply, List.of(), shows);
    }

    /** Whether the device did nothing in a wait that began when it showed {@code before}. */
    boolean isQuiet(String before) {
        return reply == Reply.WAITED && acts.isEmpty() && shows.equals(before);
    }

    /** For messages: {@code accepted, shows On}. */
    @Override
    public String toString() {
        return reply.label + (acts.isEmpty() ? "" : ", does " + String.join(", ", acts)) + ", shows " + shows;
    }

    /** How a device takes an input. */
    public enum Reply {
        /** It took it, or nothing says that it did not. */
        ACCEPTED("accepted"),
        /** It said no. */
        REFUSED("refused"),
        /** It said nothing, although it answers what it takes. */
        UNANSWERED("unanswered"),
        /** Nothing was pressed. */
        WAITED("waited"),
        /** A rule forbids the input, so it was not pressed. */
        FORBIDDEN("forbidden");

        private final String label;

        Reply(String label) {
            this.label = label;
        }
    }
}
