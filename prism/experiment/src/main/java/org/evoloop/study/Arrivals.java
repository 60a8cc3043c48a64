package org.evoloop.study;

import java.time.Duration;
import java.util.NavigableMap;
import java.util.TreeMap;

/**
 * The controller's events and what became of each, by the bench's own book: what the converter counts has no say in it.
 * An event that was never handed over to the device is lost.
 *
 * <p>Threading: for one thread at a time.
 */
final class Arrivals {
    /** An event is identified by its time; the value is the time at which it was handed over. */
    private final NavigableMap<Long, Long> handedOver = new TreeMap<>();

    private static final long NEVER = -1;

    /** Hears of waiting times. */
    interface WaitListener {
        void waited(Duration wait);
    }

    void arrive(long nanos) {
        if (handedOver.put(nanos, NEVER) != null) {
            throw new IllegalStateException("two events arrived at " + nanos + " ns");
        }
    }

    /** @throws IllegalStateException if there is no such event, or it was handed over before */
    void handOver(long arrivedNanos, long nowNanos) {
        Long before = handedOver.replace(arrivedNanos, nowNanos);
        if (before == null || before != NEVER) {
            throw new IllegalStateException("the converter handed over an event of " + arrivedNanos + " ns "
                    + (before == null ? "that never arrived" : "twice"));
        }
    }

    int size() {
        return handedOver.size();
    }

    /** How many of those that arrived after {@code first} and not after {@code last} were never handed over. */
    long lost(long firstNanos, long lastNanos) {
        return handedOver.subMap(firstNanos, false, lastNanos, true).values().stream()
                .filter(when -> when == NEVER)
                .count();
    }

    /** How many were handed over, until then. */
    long handedOver(long lastNanos) {
        return handedOver.values().stream()
                .filter(when -> when != NEVER && when <= lastNanos)
                .count();
    }

    /** Reports how long each event has waited that arrived after {@code first} and not after {@code last}. */
    void waits(long firstNanos, long lastNanos, WaitListener listener) {
        handedOver.subMap(firstNanos, false, lastNanos, true).forEach((arrived, when) -> {
            if (when != NEVER) {
                listener.waited(Duration.ofNanos(when - arrived));
            }
        });
    }
}
