package org.evoloop.lightbulb;

import java.time.Duration;
import org.evoloop.converter.StateKnowledge;
import org.evoloop.evolution.ModelPair;

/** Knows both models and the functions of the new states. */
final class LampKnowledge extends StateKnowledge {
    private final Lamp lamp;

    LampKnowledge(ModelPair models, Lamp lamp) {
        super(models);
        this.lamp = lamp;
    }

    @Override
    protected void registerNewFunctions() {
        timer("wait", "timeout", Duration.ofSeconds(2));
        function("incandescentOn", visit -> {
            lamp.filter(true);
            visit.onEnd(() -> lamp.filter(false));
        });
    }
}
