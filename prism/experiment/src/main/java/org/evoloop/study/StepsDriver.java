package org.evoloop.study;

import org.evoloop.converter.EventMonitor;
import org.evoloop.converter.SystemEventConverter;

/** Takes a loop without threads through its events, one at a time. */
final class StepsDriver implements LoopDriver {
    private final SystemEventConverter converter;

    private final EventMonitor controller;

    StepsDriver(SystemEventConverter converter, EventMonitor controller) {
        this.converter = converter;
        this.controller = controller;
    }

    @Override
    public void settle() {
        while (converter.step()) {
            // one event after the other
        }
    }

    @Override
    public void pressed() {
        try {
            converter.observe(controller);
        } catch (InterruptedException stop) {
            Thread.currentThread().interrupt();
        }
    }

    @Override
    public void dealtWith() {}
}
