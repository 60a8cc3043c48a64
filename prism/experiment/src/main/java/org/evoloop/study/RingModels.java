package org.evoloop.study;

import java.util.List;
import org.evoloop.evolution.ModelPair;
import org.evoloop.statemachine.StateMachine;
import org.evoloop.statemachine.StateMachineBuilder;

/**
 * The models of the experiment: the device knows a ring of states and the event {@value #NEXT}; the new model adds
 * {@value #JUMP}, for which the converter has to send the device two events.
 */
final class RingModels {
    static final List<String> STATES = List.of("a", "b", "c");
    static final String NEXT = "next";
    static final String JUMP = "jump";

    private RingModels() {}

    static ModelPair pair() {
        return new ModelPair(ring().build(), withJumps().build());
    }

    private static StateMachineBuilder ring() {
        StateMachineBuilder ring = StateMachine.named("ring").initial(STATES.get(0));
        for (int from = 0; from < STATES.size(); from++) {
            ring.transition(STATES.get(from), NEXT, STATES.get((from + 1) % STATES.size()));
        }
        return ring;
    }

    private static StateMachineBuilder withJumps() {
        StateMachineBuilder jumping = ring();
        for (int from = 0; from < STATES.size(); from++) {
            jumping.transition(STATES.get(from), JUMP, STATES.get((from + 2) % STATES.size()));
        }
        return jumping;
    }

    /** The event that takes the device so many steps on. */
    static String event(int steps) {
        return steps == 1 ? NEXT : JUMP;
    }
}
