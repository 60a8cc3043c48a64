package org.evoloop.converter.running;

import java.time.Duration;
import java.time.Instant;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.List;
import org.evoloop.converter.HistoryEntry;
import org.evoloop.converter.Probation;
import org.evoloop.converter.Shadow;
import org.evoloop.converter.ShadowReport;
import org.evoloop.engine.Core;
import org.evoloop.engine.Input;
import org.evoloop.engine.Output;
import org.evoloop.engine.Outputs;
import org.evoloop.engine.Rules;
import org.evoloop.engine.Swap;
import org.evoloop.evolution.DecisionTable;
import org.evoloop.evolution.DeviceEvents;
import org.evoloop.evolution.ModelPair;
import org.evoloop.evolution.Occurrence;
import org.evoloop.rehearsal.Comparison;
import org.evoloop.rehearsal.Difference;
import org.evoloop.rehearsal.Ending;
import org.evoloop.rehearsal.Verdict;
import org.evoloop.time.Clock;
import org.jspecify.annotations.Nullable;

/**
 * The core of a {@link Shadow}: a second one beside the running core.
 *
 * <p>Threading: guarded by the lock of its {@link CoreDriver}.
 */
final class ShadowCore {
    private final String model;
    private final Clock clock;
    private final Instant since;
    private final Core core;
    private final Comparison comparison = new Comparison(this::compared, this::otherEnded);
    private final Probation.Watch watch;
    private Rules rules;
    private final Deque<Difference> kept = new ArrayDeque<>();
    private final Deque<ShadowReport.Fault> faults = new ArrayDeque<>();
    private long events;
    private long different;

    /**
     * Begins in the running models' states, mapped to the others.
     *
     * @param watches check the others' result for each event
     */
    ShadowCore(Core core, Swap swap, Probation.Watches watches, Clock clock) {
        this.model = swap.name();
        this.core = core;
        this.rules = swap.rules();
        this.clock = clock;
        this.since = clock.wallTime();
        Core placed = new Core(core.rules(), core.snapshot(), output -> {});
        placed.evolved(swap, clock.nanoTime());
        this.watch = watches.begin(swap.rules().table(), placed.snapshot().at());
        comparison.begin(core, swap.rules(), placed.snapshot());
    }

    /** Receives the running core's outputs. */
    Outputs hears() {
        return comparison.hears();
    }

    /** The running core has received this input. */
    void took(Input input) {
        if (input instanceof Input.Changed changed) {
            rules = with(changed.rules().table().device());
            comparison.use(rules, changed.atNanos());
        }
        if (input instanceof Input.Observed observed && isRefused(observed.occurrence())) {
            comparison.missed();
        } else {
            comparison.took(input);
        }
    }

    /** The other models' rules with the events that the running converter's components send and report now. */
    private Rules with(DeviceEvents now) {
        ModelPair models = rules.table().models();
        DeviceEvents own = rules.table().device();
        DeviceEvents device = new DeviceEvents(
                        now.sendable(),
                        now.spontaneous(),
                        own.costs(),
                        own.doNotPass(),
                        own.boundGuards(),
                        own.onFailure())
                .declaredBy(models.original());
        return device.equals(own) ? rules : rules.with(DecisionTable.compile(models, device));
    }

    /** Whether the running models have no such event, or the device no such state: it has ended before it comes here. */
    private boolean isRefused(Occurrence occurrence) {
        return occurrence instanceof Occurrence.Heard heard
                ? !core.rules().table().names().knows(heard.event())
                : occurrence instanceof Occurrence.Found found
                        && !core.rules().table().models().original().hasState(found.state());
    }

    private void compared(Occurrence occurrence, @Nullable Verdict then, @Nullable Verdict now) {
        events++;
        if (then == null || now == null || !then.isSame(now)) {
            different++;
            keep(kept, new Difference(at(occurrence), occurrence, then, now));
        }
    }

    private Instant at(Occurrence occurrence) {
        return clock.wallTime().minusNanos(clock.nanoTime() - occurrence.observedNanos());
    }

    private static <T> void keep(Deque<T> all, T newest) {
        all.add(newest);
        if (all.size() > ShadowReport.MOST_KEPT) {
            all.remove();
        }
    }

    private void otherEnded(Ending ending) {
        Output.Ended ended = ending.ended();
        String fault = fault(new HistoryEntry(
                events + 1,
                clock.wallTime(),
                ended.occurrence(),
                ended.before(),
                ended.after(),
                ended.outcome(),
                ended.detail(),
                ended.decision(),
                Duration.ZERO));
        if (!fault.isEmpty()) {
            keep(faults, new ShadowReport.Fault(at(ended.occurrence()), fault));
        }
    }

    private String fault(HistoryEntry entry) {
        try {
            return watch.faultIn(entry);
        } catch (RuntimeException failure) {
            // A failing check of the shadow must not stop the running models.
            return "what watches the properties has failed: " + failure;
        }
    }

    /** The report so far. */
    ShadowReport report() {
        comparison.pass(clock.nanoTime());
        return new ShadowReport(
                model, since, comparison.at(), events, different, List.copyOf(kept), List.copyOf(faults));
    }
}
