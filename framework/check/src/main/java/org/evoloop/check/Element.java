package org.evoloop.check;

import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.State;
import org.evoloop.statemachine.Transition;

/**
 * The part of a machine that a finding is about.
 *
 * <p>Threading: immutable.
 *
 * @since 0.1
 */
public sealed interface Element {
    /** Which of the two machines it belongs to. */
    ModelRole side();

    /** The state, event or transition. */
    Object part();

    /** The machines of a pair. */
    enum ModelRole {
        /** The device as it is. */
        ORIGINAL,
        /** The device as it should be. */
        NEW
    }

    /** A state. */
    record OfState(ModelRole side, State state) implements Element {
        @Override
        public Object part() {
            return state;
        }

        @Override
        public String toString() {
            return state.toString();
        }
    }

    /** An event. */
    record OfEvent(ModelRole side, Event event) implements Element {
        @Override
        public Object part() {
            return event;
        }

        @Override
        public String toString() {
            return event.toString();
        }
    }

    /** A transition. */
    record OfTransition(ModelRole side, Transition transition) implements Element {
        @Override
        public Object part() {
            return transition;
        }

        @Override
        public String toString() {
            return transition.toString();
        }
    }
}
