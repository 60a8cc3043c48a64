package org.evoloop.study;

import java.util.function.BooleanSupplier;
import org.evoloop.converter.EventMonitor;
import org.evoloop.converter.SystemEventConverter;

/** Takes a loop without threads through its events, one at a time. */
final class StepsDriver implements LoopDriver {
    private final SystemEventConverter converter;
    private final EventMonitor controller;
    private final BooleanSupplier mayStep;

    /** @param mayStep asked before each event whether it may begin */
    StepsDriver(SystemEventConverter converter, EventMonitor controller, BooleanSupplier mayStep) {
        this.converter = converter;
        this.controller = controller;
        this.mayStep = mayStep;
    }

    @Override
    public void settle() {
        while (mayStep.getAsBoolean() && converter.step()) {
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
