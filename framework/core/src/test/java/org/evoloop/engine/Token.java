package org.evoloop.engine;

import java.util.Set;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.State;

/** Something that has happened at the device and is not yet reported. */
sealed interface Token {
    /**
     * The device did this by itself, unless its guards prevented it.
     *
     * @param holding the guards that held
     */
    record Own(Event event, Set<String> holding) implements Token {}

    /** The device was found there. */
    record Seen(State state) implements Token {}

    /** The step that was sent for this occurrence has had its effect. */
    record Effect(long number) implements Token {}
}
