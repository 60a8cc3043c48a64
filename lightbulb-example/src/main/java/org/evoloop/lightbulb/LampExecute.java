package org.evoloop.lightbulb;

import java.util.Set;
import org.evoloop.converter.EventExecute;
import org.evoloop.evolution.Step;

/** Sends events to the lamp. */
final class LampExecute extends EventExecute {
    private final Lamp lamp;

    LampExecute(Lamp lamp) {
        this.lamp = lamp;
    }

    @Override
    protected Set<String> sendableEvents() {
        return Set.of("switch");
    }

    @Override
    protected void send(Step step) {
        lamp.toggle();
    }
}
