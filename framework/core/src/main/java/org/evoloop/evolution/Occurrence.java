package org.evoloop.evolution;

import static java.util.Objects.requireNonNull;

import java.util.List;
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

    /** The time of its observation, in nanoseconds of the converter's monotonic clock. */
    long observedNanos();

    /** Its name in logs: the event, or the state found. */
    String label();

    /** Where it came from. */
    Source source();

    /**
     * Whether it has already happened at the device, so that the device's state has changed before anything is decided.
     * Such a fact is never refused.
     */
    boolean isFact();

    /**
     * The visit of a state it belongs to, or {@link #ANY_VISIT}. An event raised during one visit is stale in the next.
     */
    default long visit() {
        return ANY_VISIT;
    }

    /** Its values. */
    default Values values() {
        return Values.NONE;
    }

    /** Whether it is one of these events, by their names without guards. */
    default boolean is(String... events) {
        return this instanceof Heard heard
                && List.of(events).contains(heard.event().name());
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

        /** Nothing may be null. */
        public Heard {
            requireNonNull(event, "the event is null");
            requireNonNull(values, "the values of an event are null; Values.NONE are none");
            requireNonNull(source, "the source of an event is null");
            requireNonNull(holding, "the guards of an event are null");
        }

        /** An event on which the device has not acted. */
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
     * The device was found in a state, after it was unreachable or did something that its model does not describe.
     *
     * @param state a state of the original model
     */
    record Found(State state, long observedNanos) implements Occurrence {
        /** The state may not be null. */
        public Found {
            requireNonNull(state, "the state in which the device was found is null");
        }

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
     * A new function sends an event to the device; the new model stays where it is.
     *
     * @param event an event of the original model
     */
    record Asked(Event event, Values values, long visit, long observedNanos) implements Occurrence {
        /** Nothing may be null. */
        public Asked {
            requireNonNull(event, "the event is null");
            requireNonNull(values, "the values of an event are null; Values.NONE are none");
        }

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
            return event + " (asked by a function" + (values.isEmpty() ? "" : ", " + values) + ")";
        }
    }

    /**
     * The converter is no longer sure of the device's state: it does not know whether an event that was sent had its
     * effect, or in which order things happened.
     *
     * @param why for people
     */
    record InDoubt(String why, long observedNanos) implements Occurrence {
        /** The reason may not be null. */
        public InDoubt {
            requireNonNull(why, "the reason of a doubt is null");
        }

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
     * A property that is watched over time is violated. It needs no handling.
     *
     * @param property its name
     */
    record Violated(String property, long observedNanos) implements Occurrence {
        /** The name may not be null. */
        public Violated {
            requireNonNull(property, "the name of a violated property is null");
        }

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
     * Other models have taken over, and the states of device and new model are not yet a reachable pair.
     *
     * @param model the name of the new model
     */
    record Evolved(String model, long observedNanos) implements Occurrence {
        /** The name may not be null. */
        public Evolved {
            requireNonNull(model, "the name of the new model is null");
        }

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
