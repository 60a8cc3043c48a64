package org.evoloop.fleet.stream;

import org.apache.kafka.streams.processor.api.ProcessingContext;
import org.evoloop.fleet.wire.Refusal;
import org.evoloop.fleet.wire.Wire;

/** The current time: by this machine's clock, or by the latest record of the partition. */
final class Clock {
    private final ProcessingContext context;
    private final FleetSettings settings;

    Clock(ProcessingContext context, FleetSettings settings) {
        this.context = context;
        this.settings = settings;
    }

    long nowMillis() {
        return isWall() ? context.currentSystemTimeMs() : context.currentStreamTimeMs();
    }

    boolean isWall() {
        return settings.isWallClock();
    }

    /** {@code millis}, or now if that is earlier, in nanoseconds. */
    long atMost(long millis) {
        return Wire.nanos(Math.min(millis, nowMillis()));
    }

    /**
     * Rejects implausible times: after a time in the future, timers would expire early from then on.
     *
     * @throws Refusal if {@code atNanos} is too far from now
     */
    void requireLikely(long atNanos) {
        long ahead = Wire.millis(atNanos) - nowMillis();
        if (ahead > settings.clockAhead().toMillis()) {
            throw new Refusal(Refusal.Reason.CLOCK, "it is " + ahead + " ms ahead of this machine's clock");
        } else if (-ahead > settings.clockBehind().toMillis()) {
            throw new Refusal(Refusal.Reason.CLOCK, "it is " + -ahead + " ms behind this machine's clock");
        }
    }
}
