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

    /** @param edition that of the new model: each edition adds one event, which is never used */
    static ModelPair pair(int edition) {
        return new ModelPair(ring("ring").build(), withJumps(edition).build());
    }

    private static StateMachineBuilder ring(String name) {
        StateMachineBuilder ring = StateMachine.named(name).initial(STATES.get(0));
        for (int from = 0; from < STATES.size(); from++) {
            ring.transition(STATES.get(from), NEXT, STATES.get((from + 1) % STATES.size()));
        }
        return ring;
    }

    private static StateMachineBuilder withJumps(int edition) {
        StateMachineBuilder jumping = ring("ring with jumps " + edition);
        for (int from = 0; from < STATES.size(); from++) {
            jumping.transition(STATES.get(from), JUMP, STATES.get((from + 2) % STATES.size()));
        }
        for (int extra = 1; extra <= edition; extra++) {
            jumping.transition(STATES.get(0), "extra" + extra, STATES.get(1));
        }
        return jumping;
    }

    /** The event that takes the device so many steps on. */
    static String event(int steps) {
        return steps == 1 ? NEXT : JUMP;
    }
}
