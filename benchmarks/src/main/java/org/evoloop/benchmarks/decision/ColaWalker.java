package org.evoloop.benchmarks.decision;

import com.alibaba.cola.statemachine.StateMachine;
import com.alibaba.cola.statemachine.builder.StateMachineBuilder;
import com.alibaba.cola.statemachine.builder.StateMachineBuilderFactory;

/** COLA's state machine component 5.0.0. It is stateless; its caller keeps the state. */
final class ColaWalker extends Walker {
    private final StateMachine<String, String, ColaWalker> machine;
    private String state;

    ColaWalker(Walk walk) {
        StateMachineBuilder<String, String, ColaWalker> builder = StateMachineBuilderFactory.create();
        for (Walk.Move move : walk.moves()) {
            builder.externalTransition()
                    .from(move.source())
                    .to(move.target())
                    .on(move.event())
                    .perform((from, to, event, walker) -> walker.act());
        }
        // Machines are registered permanently under their ids.
        machine = builder.build("walk-" + System.identityHashCode(this));
        state = walk.initial();
    }

    @Override
    void fire(String event) {
        state = machine.fireEvent(state, event, this);
    }
}
