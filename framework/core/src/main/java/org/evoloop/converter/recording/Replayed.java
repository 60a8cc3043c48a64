package org.evoloop.converter.recording;

import java.time.Instant;
import java.util.function.LongSupplier;
import java.util.function.Supplier;
import org.evoloop.converter.ConverterJournal;
import org.evoloop.engine.Output;
import org.evoloop.engine.Pending;
import org.evoloop.evolution.Configuration;
import org.evoloop.evolution.Decision;
import org.evoloop.evolution.Occurrence;
import org.evoloop.evolution.Outcome;
import org.jspecify.annotations.Nullable;

/** Receives replayed outputs of a core: they go into the history and the latency, and are not carried out again. */
public final class Replayed implements ConverterJournal.Past {
    private final History history;
    private final LatencyWindow latency;
    private Supplier<Instant> time = () -> Instant.EPOCH;
    private LongSupplier nanos = () -> 0;

    private Configuration at;

    public Replayed(History history, LatencyWindow latency, Configuration at) {
        this.history = history;
        this.latency = latency;
        this.at = at;
    }

    @Override
    public void at(Supplier<Instant> then, LongSupplier thenNanos) {
        time = then;
        nanos = thenNanos;
    }

    @Override
    public void moved(Configuration before, Configuration after) {
        at = after;
    }

    @Override
    public void say(Output output) {
        // Was carried out, or reported, the first time.
    }

    @Override
    public void decided(Pending pending, Decision decision, long waitedNanos) {
        latency.record(waitedNanos);
    }

    @Override
    public void dropped(Occurrence occurrence, boolean first) {
        history.record(
                time.get(), nanos.getAsLong(), occurrence, at, at, Outcome.DROPPED, null, "the queue was full", "");
    }

    @Override
    public void ended(
            Occurrence occurrence,
            Configuration before,
            Configuration after,
            Outcome outcome,
            @Nullable Decision decision,
            String detail) {
        history.record(time.get(), nanos.getAsLong(), occurrence, before, after, outcome, decision, detail, "");
    }
}
