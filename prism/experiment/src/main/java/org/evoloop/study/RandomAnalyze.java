package org.evoloop.study;

import java.util.Objects;
import org.evoloop.converter.Analysis;
import org.evoloop.converter.EventAnalyze;
import org.evoloop.evolution.Occurrence;
import org.jspecify.annotations.Nullable;

/** The framework's decision, taking a random conversion time. */
final class RandomAnalyze extends EventAnalyze {
    private final SimulatedTime time;
    private final RandomTimes times;
    private final Point point;
    private final SimulatedDevice device;
    private @Nullable Occurrence current;

    RandomAnalyze(SimulatedTime time, RandomTimes times, Point point, SimulatedDevice device) {
        this.time = time;
        this.times = times;
        this.point = point;
        this.device = device;
    }

    @Override
    protected @Nullable Analysis analyze(Occurrence occurrence) {
        current = occurrence;
        if (point.mechanism() == Point.Mechanism.SERIAL) {
            time.pass(device.untilReady());
        }
        time.pass(times.conversion(point.conversionSeconds()));
        return super.analyze(occurrence);
    }

    /** When the event that is in the loop was observed. */
    long observedNanos() {
        return Objects.requireNonNull(current).observedNanos();
    }
}
