package org.evoloop.converter;

import java.time.Instant;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.List;
import org.evoloop.core.Core;
import org.evoloop.core.Input;
import org.evoloop.core.Outputs;
import org.evoloop.core.Swap;
import org.evoloop.evolution.Occurrence;
import org.evoloop.rehearsal.Chronicle;
import org.evoloop.rehearsal.Comparison;
import org.evoloop.rehearsal.Difference;
import org.evoloop.rehearsal.Verdict;
import org.evoloop.time.Clock;
import org.jspecify.annotations.Nullable;

/**
 * What a {@link Shadow} decides: a second core beside the one that runs.
 *
 * <p>Threading: guarded by the lock of its {@link CoreDriver}.
 */
final class ShadowCore {
    /** So many differences are remembered. */
    static final int MOST_KEPT = 1_000;

    private final String model;
    private final Clock clock;
    private final Instant since;
    private final Core core;
    private final Chronicle running;
    private final Comparison comparison = new Comparison(this::compared, ending -> {});
    private final Deque<Difference> kept = new ArrayDeque<>();
    private long events;
    private long different;

    /** Begins where the running models are, in terms of the others. */
    ShadowCore(Core core, Swap swap, Clock clock) {
        this.model = swap.name();
        this.core = core;
        this.clock = clock;
        this.since = clock.wallTime();
        this.running =
                new Chronicle(core.snapshot().visit().number(), ending -> comparison.ended(ending, clock.nanoTime()));
        Core placed = new Core(core.rules(), core.snapshot(), output -> {});
        placed.evolved(swap, clock.nanoTime());
        comparison.begin(swap.rules(), Comparison.still(placed.snapshot()));
    }

    /** Who has to hear what the running core says. */
    Outputs hears() {
        return running;
    }

    /** An event waits for its turn, and the device's own has moved the record already. */
    void observed(Occurrence occurrence) {
        boolean current = occurrence.visit() == running.visit();
        comparison.observed(occurrence, current ? core.at().evolved() : null, clock.nanoTime());
    }

    /** The converter was opened or closed. */
    void follow(Input input) {
        comparison.follow(input, clock.nanoTime());
    }

    private void compared(Occurrence occurrence, @Nullable Verdict then, @Nullable Verdict now) {
        events++;
        if (then == null || now == null || !then.isSame(now)) {
            different++;
            Instant at = clock.wallTime().minusNanos(clock.nanoTime() - occurrence.observedNanos());
            kept.add(new Difference(at, occurrence, then, now));
            if (kept.size() > MOST_KEPT) {
                kept.remove();
            }
        }
    }

    /** How it stands now. */
    ShadowReport report() {
        comparison.pass(clock.nanoTime());
        return new ShadowReport(model, since, comparison.at(), events, different, List.copyOf(kept));
    }
}
