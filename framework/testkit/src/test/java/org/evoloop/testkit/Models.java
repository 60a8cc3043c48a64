package org.evoloop.testkit;

import org.evoloop.evolution.ModelPair;
import org.evoloop.statemachine.StateMachine;

/** The models of these tests. */
final class Models {
    /** A device with its own buttons. */
    static final StateMachine PLAYER = StateMachine.named("original")
            .initial("Stopped")
            .transition("Stopped", "play", "Playing")
            .transition("Playing", "pause", "Paused")
            .transition("Paused", "play", "Playing")
            .transition("Playing", "stop", "Stopped")
            .transition("Paused", "stop", "Stopped")
            .transition("Playing", "ended", "Stopped")
            .spontaneous("ended")
            .build();

    private Models() {}

    /** The unchanged player: the new model is the original one. */
    static ModelPair player() {
        return new ModelPair(PLAYER, PLAYER.withName("new"));
    }
}
