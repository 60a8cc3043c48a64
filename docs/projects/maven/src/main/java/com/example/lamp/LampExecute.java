package com.example.lamp;

import java.util.Set;
import org.evoloop.converter.EventExecute;
import org.evoloop.evolution.Step;

/** Sends events to the lamp. */
final class LampExecute extends EventExecute {
    @Override
    protected Set<String> sendableEvents() {
        return Set.of("switch");
    }

    @Override
    protected void send(Step step) {
        System.out.println("the lamp gets " + step.trigger());
    }
}
