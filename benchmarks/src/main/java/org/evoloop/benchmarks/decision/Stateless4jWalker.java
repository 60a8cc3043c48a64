package org.evoloop.benchmarks.decision;

import com.github.oxo42.stateless4j.StateMachine;
import com.github.oxo42.stateless4j.StateMachineConfig;

/** stateless4j 2.6.0. */
final class Stateless4jWalker extends Walker {
    private final StateMachine<String, String> machine;

    Stateless4jWalker(Walk walk) {
        StateMachineConfig<String, String> config = new StateMachineConfig<>();
        for (Walk.Move move : walk.moves()) {
            config.configure(move.source()).permit(move.event(), move.target(), this::act);
        }
        machine = new StateMachine<>(walk.initial(), config);
    }

    @Override
    void fire(String event) {
        machine.fire(event);
    }
}
