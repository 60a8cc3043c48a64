package org.evoloop.testkit;

import java.util.Set;
import org.evoloop.converter.EventExecute;
import org.evoloop.evolution.Step;

/** Sends to nobody. */
final class NotingExecute extends EventExecute {
    private final Set<String> sendable;

    NotingExecute(String... sendable) {
        this.sendable = Set.of(sendable);
    }

    @Override
    protected Set<String> sendableEvents() {
        return sendable;
    }

    @Override
    protected void send(Step step) {}
}
