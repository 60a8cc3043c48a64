package org.evoloop.check.timing;

import java.util.Set;
import org.evoloop.statemachine.Event;
import org.jspecify.annotations.Nullable;

/**
 * Something that can happen to a converter in one instant.
 *
 * @param event null for {@link Kind#LANDS}
 * @param timer the place of the timer that is due; -1 if none is
 * @param holding the guards of the original model under which the device acts
 */
record Stimulus(Kind kind, @Nullable Event event, int timer, Set<String> holding) {
    enum Kind {
        /** Somebody operates a control of the controller. */
        PRESS,
        /** The device acts by itself. */
        ACT,
        /** The function of the current state raises an event. */
        RAISE,
        /** A violation of a property raises an event. */
        REACT,
        /** A timer of the current state is due. */
        TIMER,
        /** The step on its way has had its effect. */
        LANDS
    }

    static Stimulus of(Kind kind, Event event) {
        return new Stimulus(kind, event, -1, Set.of());
    }

    static Stimulus timer(Event event, int place) {
        return new Stimulus(Kind.TIMER, event, place, Set.of());
    }

    static final Stimulus LANDING = new Stimulus(Kind.LANDS, null, -1, Set.of());
}
