package org.evoloop.service;

import java.time.Duration;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import org.evoloop.converter.ConverterStatus;
import org.evoloop.converter.SystemEventConverter;
import org.evoloop.loop.ComponentStatus;
import org.evoloop.loop.LoopState;

/**
 * Checks that converters respond. For each converter: its lock can be acquired; its clock runs tasks, which include
 * giving up components that hang; its threads are alive; and if events are waiting, at least one was handled since the
 * last check.
 *
 * <p>Threading: one thread, which blocks while a converter's lock is held.
 */
final class Pulse {
    private static final long CLOCK_LIMIT_SECONDS = 1;

    private final List<SystemEventConverter> converters;
    private final Map<SystemEventConverter, Long> taken = new HashMap<>();

    Pulse(List<SystemEventConverter> converters) {
        this.converters = List.copyOf(converters);
    }

    /** What is wrong with the first converter that does not respond; empty if all do. */
    String trouble() throws InterruptedException {
        for (SystemEventConverter converter : converters) {
            String trouble = trouble(converter);
            if (!trouble.isEmpty()) {
                return converter.status().name() + " " + trouble;
            }
        }
        return "";
    }

    private String trouble(SystemEventConverter converter) throws InterruptedException {
        ConverterStatus status = converter.status();
        if (status.loop() == LoopState.EXITED) {
            return "has ended";
        }
        CountDownLatch ticked = new CountDownLatch(1);
        converter.clock().schedule(Duration.ZERO, ticked::countDown);
        if (!ticked.await(CLOCK_LIMIT_SECONDS, TimeUnit.SECONDS)) {
            return "has a clock that does not run its tasks";
        }
        for (ComponentStatus component : status.components()) {
            if (component.activity() == ComponentStatus.Activity.ENDED) {
                return "has lost the thread of " + component.name();
            }
        }
        long done = status.queue().taken() - status.queue().depth();
        Long before = taken.put(converter, done);
        boolean stands = status.queue().depth() > 0 && before != null && before == done;
        return stands ? "lets events wait" : "";
    }
}
