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
        public String toString() {
            String events = sent.stream().map(Event::toString).collect(Collectors.joining(", "));
            return "handled: " + to.evolved() + (events.isEmpty() ? "" : ", sent " + events);
        }
    }

    /**
     * The new model has no transition for it in the present state, or none whose guards hold.
     *
     * @param why with the guards that did not hold
     */
    record NotAcceptable(String why) implements EventOutcome {
        @Override
        public String toString() {
            return why;
        }
    }

    /** A rule of the converter does not allow it, or the converter is stopped, or cannot write its journal. */
    record Refused(String why) implements EventOutcome {
        @Override
        public String toString() {
            return "refused: " + why;
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
        public String toString() {
            return "failed: " + why;
        }
    }

    /** Its plan was overtaken, by an urgent event or by what the device did itself. */
    record Overtaken(Configuration from, Configuration to, String why) implements EventOutcome {
        @Override
        public String toString() {
            return why;
        }
    }

    /** The queue was full. */
    record Dropped(String why) implements EventOutcome {
        @Override
        public String toString() {
            return "dropped: " + why;
        }
    }

    /** Its turn came too long after it was pressed, or after the state that asked for it had been left. */
    record Stale(String why) implements EventOutcome {
        @Override
        public String toString() {
            return "stale: " + why;
        }
    }
}
