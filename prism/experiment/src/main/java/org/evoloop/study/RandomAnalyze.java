package org.evoloop.study;

import org.evoloop.converter.Analysis;
import org.evoloop.converter.EventAnalyze;
import org.evoloop.evolution.Occurrence;
import org.jspecify.annotations.Nullable;

/** The framework's decision, taking a random conversion time. */
final class RandomAnalyze extends EventAnalyze {
    private final Surroundings surroundings;
    private final RandomTimes times;
    private final Point point;
    private @Nullable Occurrence current;

    RandomAnalyze(Surroundings surroundings, RandomTimes times, Point point) {
        this.surroundings = surroundings;
        this.times = times;
        this.point = point;
    }

    @Override
    protected @Nullable Analysis analyze(Occurrence occurrence) {
        current = occurrence;
        if (occurrence instanceof Occurrence.Heard) {
            if (point.mechanism() == Point.Mechanism.SERIAL) {
                surroundings.awaitDevice();
            }
            surroundings.pass(times.conversion(point.conversion()));
        }
        return super.analyze(occurrence);
    }

    /** The event that is in the loop; null if what is there is none of the controller's. */
    Occurrence.@Nullable Heard event() {
        return current instanceof Occurrence.Heard heard ? heard : null;
    }
}
