package org.evoloop.converter;

import java.util.Set;
import org.evoloop.evolution.Step;

/** An execute component that can send one event, and does so at once. */
class Part extends EventExecute {
    final String event;

    Part(String name, String event) {
        super(name);
        this.event = event;
    }

    @Override
    protected Set<String> sendableEvents() {
        return Set.of(event);
    }

    @Override
    protected void send(Step step) {}
}
