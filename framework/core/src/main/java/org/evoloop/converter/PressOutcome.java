package org.evoloop.converter;

import java.util.List;
import java.util.stream.Collectors;
import org.evoloop.evolution.Configuration;
import org.evoloop.statemachine.Event;

/**
 * What became of an event that was {@linkplain PushMonitor#submit submitted}. For people by {@code toString}.
 *
 * <p>Threading: immutable.
 *
 * @since 0.1
 */
public sealed interface PressOutcome {
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
    record Handled(Configuration from, Configuration to, List<Event> sent) implements PressOutcome {
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
    record NotAcceptable(String why) implements PressOutcome {
        @Override
        public String toString() {
            return why;
        }
    }

    /** A rule of the converter does not allow it, or the converter is stopped, or cannot write its journal. */
    record Refused(String why) implements PressOutcome {
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
    record Failed(Configuration from, Configuration to, String why) implements PressOutcome {
        @Override
        public String toString() {
            return "failed: " + why;
        }
    }

    /** Its plan was overtaken, by an urgent event or by what the device did itself. */
    record Overtaken(Configuration from, Configuration to, String why) implements PressOutcome {
        @Override
        public String toString() {
            return why;
        }
    }

    /** The queue was full. */
    record Dropped(String why) implements PressOutcome {
        @Override
        public String toString() {
            return "dropped: " + why;
        }
    }

    /** Its turn came too long after it was pressed. */
    record Stale(String why) implements PressOutcome {
        @Override
        public String toString() {
            return "stale: " + why;
        }
    }
}
