package org.evoloop.converter.recording;

import org.evoloop.evolution.Configuration;
import org.evoloop.evolution.Decision;
import org.evoloop.evolution.Occurrence;
import org.evoloop.evolution.Outcome;
import org.evoloop.loop.Failure;
import org.evoloop.loop.LoopConfig;
import org.jspecify.annotations.Nullable;

/**
 * The records of a converter's activity, and its listeners.
 *
 * <p>Threading: as for each of them.
 */
public record Records(
        Transcript transcript,
        FailureLog failures,
        History history,
        LatencyWindow latency,
        DriftWindow drift,
        FlightLog flight,
        Listeners listeners) {

    public Records(LoopConfig config, FailureLog failures, Listeners listeners) {
        this(
                new Transcript(config.name()),
                failures,
                new History(config.clock()),
                new LatencyWindow(),
                new DriftWindow(config.clock()),
                new FlightLog(config.name()),
                listeners);
    }

    /**
     * Records an occurrence that has ended.
     *
     * @param left see {@link History#record}
     */
    public void record(
            Occurrence occurrence,
            Configuration before,
            Configuration after,
            Outcome outcome,
            @Nullable Decision decision,
            String detail,
            String left) {
        history.record(occurrence, before, after, outcome, decision, detail, left);
        flight.ended(occurrence, before, after, outcome, detail);
        listeners.endings().ended(occurrence, before, after, outcome, decision, detail);
        listeners.ended(history);
    }

    /** The journal no longer records the converter's inputs. */
    public void journalFailed(Exception cause) {
        failures.countFault("journal", String.valueOf(cause.getMessage()));
        failures.warn(cause.getMessage() + ". Until then controllers' events are refused and nothing is sent");
        listeners.failed(new Failure<>("journal", "write", 0, null, cause));
    }

    /** The journal records them again. */
    public void journalWorks() {
        failures.forget("journal");
        failures.warn("the journal is written again");
    }
}
