package org.evoloop.study;

import java.util.List;
import java.util.concurrent.Semaphore;
import java.util.concurrent.TimeUnit;
import org.evoloop.converter.ConverterStatus;
import org.evoloop.converter.SystemEventConverter;
import org.evoloop.loop.Component.Role;
import org.evoloop.loop.ComponentStatus;

/** Waits for a loop with threads until it has dealt with everything that it has. */
final class ThreadsDriver implements LoopDriver {
    /** In real time, for one event, which takes microseconds. */
    private static final int PATIENCE_SECONDS = 60;

    private final SystemEventConverter converter;
    private final Semaphore dealtWith = new Semaphore(0);
    private long awaited;

    ThreadsDriver(SystemEventConverter converter) {
        this.converter = converter;
    }

    @Override
    public void settle() {
        ConverterStatus status = converter.status();
        while (awaited < status.queue().taken()) {
            awaitOne();
            status = converter.status();
        }
        // The last event has been handed over; the loop may still have to end its round.
        while (isWorking(status.components())) {
            Thread.onSpinWait();
            status = converter.status();
        }
    }

    private void awaitOne() {
        try {
            if (!dealtWith.tryAcquire(PATIENCE_SECONDS, TimeUnit.SECONDS)) {
                throw new IllegalStateException("the loop stands still: " + converter.status());
            }
        } catch (InterruptedException stop) {
            Thread.currentThread().interrupt();
            throw new IllegalStateException("interrupted", stop);
        }
        awaited++;
    }

    private static boolean isWorking(List<ComponentStatus> components) {
        return components.stream()
                .anyMatch(component ->
                        component.role() != Role.MONITOR && component.activity() == ComponentStatus.Activity.WORKING);
    }

    @Override
    public void pressed() {
        // The monitor has already reported it to the loop.
    }

    @Override
    public void dealtWith() {
        dealtWith.release();
    }
}
