package org.evoloop.evolution;

import java.util.List;
import java.util.stream.Collectors;
import org.evoloop.statemachine.Event;

/**
 * What became of an event, for whoever asked: a controller that submitted it, or a function that had it sent. For people
 * by {@code toString}.
 *
 * <p>Threading: immutable.
 *
 * @since 0.1
 */
public sealed interface EventOutcome {
    /**
     * The kind in lower case, for programs: {@code handled}, {@code not acceptable}, {@code refused}, {@code failed}, {@code
     * overtaken}, {@code dropped} or {@code stale}.
     */
    String kind();

    /** Why it had no effect, or not all of it; empty if it was handled. */
    String why();

    /** Whether it had its effect. */
    default boolean isHandled() {
        return this instanceof Handled;
    }

    /**
     * It had its effect.
     *
     * @param from the states of device and evolved system before it
     * @param to the states after it
     * @param sent what was sent to the device, in order
     */
    record Handled(Configuration from, Configuration to, List<Event> sent) implements EventOutcome {
        /** Nothing may be null. */
        public Handled {
            sent = List.copyOf(sent);
        }

        @Override
        public String kind() {
            return "handled";
        }

        @Override
        public String why() {
            return "";
        }

        @Override
        public String toString() {
            String events = sent.stream().map(Event::toString).collect(Collectors.joining(", "));
            return kind() + ": " + to.evolved() + (events.isEmpty() ? "" : ", sent " + events);
        }
    }

    /**
     * The new model has no transition for it in the present state, or none whose guards hold.
     *
     * @param why with the guards that did not hold
     */
    record NotAcceptable(String why) implements EventOutcome {
        @Override
        public String kind() {
            return "not acceptable";
        }

        @Override
        public String toString() {
            return why;
        }
    }

    /** A rule of the converter does not allow it, or the converter is stopped, or cannot write its journal. */
    record Refused(String why) implements EventOutcome {
        @Override
        public String kind() {
            return "refused";
        }

        @Override
        public String toString() {
            return kind() + ": " + why;
        }
    }

    /**
     * It could not be carried out, or not completely.
     *
     * @param from the states of device and evolved system before it
     * @param to the states after it
     */
    record Failed(Configuration from, Configuration to, String why) implements EventOutcome {
        @Override
        public String kind() {
            return "failed";
        }

        @Override
        public String toString() {
            return kind() + ": " + why;
        }
    }

    /** An urgent event ended its plan. */
    record Overtaken(Configuration from, Configuration to, String why) implements EventOutcome {
        @Override
        public String kind() {
            return "overtaken";
        }

        @Override
        public String toString() {
            return kind() + ": " + why;
        }
    }

    /** The queue was full. */
    record Dropped(String why) implements EventOutcome {
        @Override
        public String kind() {
            return "dropped";
        }

        @Override
        public String toString() {
            return kind() + ": " + why;
        }
    }

    /** Its turn came too long after it was pressed, or after the state that asked for it had been left. */
    record Stale(String why) implements EventOutcome {
        @Override
        public String kind() {
            return "stale";
        }

        @Override
        public String toString() {
            return kind() + ": " + why;
        }
    }
}
