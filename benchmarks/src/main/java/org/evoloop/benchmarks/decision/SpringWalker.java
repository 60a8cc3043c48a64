package org.evoloop.benchmarks.decision;

import java.util.HashSet;
import org.springframework.statemachine.StateMachine;
import org.springframework.statemachine.config.StateMachineBuilder;

/** Spring Statemachine 4.0.2. */
final class SpringWalker extends Walker {
    private final StateMachine<String, String> machine;

    SpringWalker(Walk walk) {
        try {
            StateMachineBuilder.Builder<String, String> builder = StateMachineBuilder.builder();
            builder.configureStates().withStates().initial(walk.initial()).states(new HashSet<>(walk.states()));
            for (Walk.Move move : walk.moves()) {
                builder.configureTransitions()
                        .withExternal()
                        .source(move.source())
                        .target(move.target())
                        .event(move.event())
                        .action(context -> act());
            }
            machine = builder.build();
        } catch (Exception broken) {
            throw new IllegalStateException(broken);
        }
        machine.startReactively().block();
    }

    @Override
    @SuppressWarnings("deprecation") // the usual call, and the cheapest
    void fire(String event) {
        machine.sendEvent(event);
    }
}
