package org.evoloop.evolution;

import java.util.Locale;
import java.util.Set;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.State;

/**
 * Something that occurred, and that the converter has to react to.
 *
 * <p>Threading: immutable.
 *
 * @since 0.1
 */
public sealed interface Occurrence {
    /** The visit of an occurrence that no state raised. */
    long ANY_VISIT = 0;

    /** When it was observed, in nanoseconds of the converter's monotonic clock. */
    long observedNanos();

    /** What it is called in logs: the event, or what was found. */
    String label();

    /** Where it came from. */
    Source source();

    /**
     * Whether it has happened at the device already, so that the device's state has moved before anything is decided. Such a
     * fact is never refused.
     */
    boolean isFact();

    /**
     * The visit of a state it belongs to, or {@link #ANY_VISIT}. What was raised during one visit means nothing to the next.
     */
    default long visit() {
        return ANY_VISIT;
    }

    /** What it carries besides its name. */
    default Values values() {
        return Values.NONE;
    }

    /**
     * An event: of a controller, the device, a timer or a new function.
     *
     * @param deviceActed whether the device has acted on it by itself
     * @param holding the guards of the original model that held when it was observed
     */
    record Heard(
            Event event,
            Values values,
            Source source,
            boolean deviceActed,
            Set<String> holding,
            long visit,
            long observedNanos)
            implements Occurrence {

        /** An event that has not moved the device. */
        public Heard(Event event, Values values, Source source, long visit, long observedNanos) {
            this(event, values, source, false, Set.of(), visit, observedNanos);
        }

        @Override
        public String label() {
            return event.toString();
        }

        @Override
        public boolean isFact() {
            return deviceActed;
        }

        /** For messages: {@code Clean (panel, the device acted)}. */
        @Override
        public String toString() {
            return event + " (" + source.name().toLowerCase(Locale.ROOT)
                    + (deviceActed ? ", the device acted" : "")
                    + (values.isEmpty() ? "" : ", " + values) + ")";
        }
    }

    /**
     * The device was found in a state, after it was out of sight or did what its model does not know.
     *
     * @param state a state of the original model
     */
    record Found(State state, long observedNanos) implements Occurrence {
        @Override
        public String label() {
            return "found " + state;
        }

        @Override
        public Source source() {
            return Source.DEVICE;
        }

        @Override
        public boolean isFact() {
            return true;
        }

        @Override
        public String toString() {
            return label();
        }
    }

    /**
     * A new function has the device do something that the device knows; the new model stays where it is.
     *
     * @param event of the original model
     */
    record Asked(Event event, Values values, long visit, long observedNanos) implements Occurrence {
        @Override
        public String label() {
            return event.toString();
        }

        @Override
        public Source source() {
            return Source.FUNCTION;
        }

        @Override
        public boolean isFact() {
            return false;
        }

        /** For messages: {@code Clean (asked by a function)}. */
        @Override
        public String toString() {
            return event + " (asked by a function)";
        }
    }

    /**
     * The converter no longer knows where the device is: whether an event that was sent had its effect, or what came first.
     *
     * @param why for people
     */
    record InDoubt(String why, long observedNanos) implements Occurrence {
        @Override
        public String label() {
            return "in doubt";
        }

        @Override
        public Source source() {
            return Source.DEVICE;
        }

        @Override
        public boolean isFact() {
            return true;
        }

        @Override
        public String toString() {
            return "in doubt: " + why;
        }
    }

    /**
     * A property that is watched over time is violated. Nothing has to be done about it.
     *
     * @param property its name
     */
    record Violated(String property, long observedNanos) implements Occurrence {
        @Override
        public String label() {
            return "violation of " + property;
        }

        @Override
        public Source source() {
            return Source.PROPERTY;
        }

        @Override
        public boolean isFact() {
            return false;
        }

        @Override
        public String toString() {
            return label();
        }
    }

    /**
     * Other models have taken over, and device and new model do not stand together in them yet.
     *
     * @param model the name of the new model
     */
    record Evolved(String model, long observedNanos) implements Occurrence {
        @Override
        public String label() {
            return "evolved to " + model;
        }

        @Override
        public Source source() {
            return Source.OWNER;
        }

        @Override
        public boolean isFact() {
            return true;
        }

        @Override
        public String toString() {
            return label();
        }
    }
}
