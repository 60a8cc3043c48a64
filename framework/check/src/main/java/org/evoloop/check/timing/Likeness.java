package org.evoloop.check.timing;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import org.evoloop.engine.Pending;
import org.evoloop.engine.Snapshot;
import org.evoloop.engine.Tally;
import org.evoloop.engine.Work;
import org.evoloop.evolution.Occurrence;
import org.evoloop.statemachine.Event;
import org.jspecify.annotations.Nullable;

/**
 * A snapshot without what is irrelevant to the future: equal for snapshots that differ only in counters and times.
 * Running timers are distinguished by deadlines far in the future.
 */
final class Likeness {
    /** The deadline of the first timer that runs; the others follow. */
    static final long RUNNING = 1L << 61;

    /** The deadline of a timer that has raised its event, which waits. */
    static final long HEARD = -1;

    static final long VISIT = 1000;
    private static final long STEPS = 1000;

    private final Snapshot of;
    private final long visit;
    private long numbers;

    private Likeness(Snapshot of) {
        this.of = of;
        this.visit = of.visit().number();
    }

    /** @param visitBefore the number of the visit in which timers that are due have raised their events */
    static Snapshot of(Snapshot snapshot, long visitBefore) {
        return new Likeness(snapshot).snapshot(visitBefore == snapshot.visit().number());
    }

    private Snapshot snapshot(boolean sameVisit) {
        Work work = of.work() == null ? null : like(of.work());
        List<Pending> waiting = of.waiting().stream().map(this::like).toList();
        return new Snapshot(
                of.open(),
                of.at(),
                of.doubt(),
                STEPS,
                0,
                new Snapshot.OpenVisit(
                        visit > 0 ? VISIT : 0,
                        of.visit().over(),
                        of.visit().by(),
                        deadlines(sameVisit),
                        of.visit().startOwed()),
                waiting,
                false,
                of.followOwed(),
                work,
                new Tally(numbers, 0, 0, 0, 0, 0, 0, 0, 0),
                0);
    }

    private Map<Event, Long> deadlines(boolean sameVisit) {
        Map<Event, Long> deadlines = new LinkedHashMap<>();
        for (Map.Entry<Event, Long> entry : new TreeMap<>(of.visit().deadlines()).entrySet()) {
            boolean heard = entry.getValue() <= 0 && sameVisit;
            deadlines.put(entry.getKey(), heard ? HEARD : RUNNING + deadlines.size());
        }
        return deadlines;
    }

    private Work like(Work work) {
        return new Work(
                like(work.pending()),
                work.decision(),
                work.taken(),
                work.effectsRun(),
                work.failedEffects(),
                work.stage(),
                work.meanwhile().stream().map(this::like).toList());
    }

    private Pending like(Pending pending) {
        return new Pending(
                ++numbers,
                like(pending.occurrence()),
                pending.from(),
                pending.own(),
                pending.stepsBefore() == of.steps() ? STEPS : STEPS - 1,
                pending.attempts());
    }

    private Occurrence like(Occurrence occurrence) {
        if (occurrence instanceof Occurrence.Heard heard) {
            long seen =
                    heard.visit() == Occurrence.ANY_VISIT ? heard.visit() : heard.visit() == visit ? VISIT : VISIT - 1;
            return new Occurrence.Heard(
                    heard.event(), heard.values(), heard.source(), heard.deviceActed(), heard.holding(), seen, 0);
        }
        return occurrence instanceof Occurrence.Found found ? new Occurrence.Found(found.state(), 0) : occurrence;
    }

    /** Where {@code event} runs among the timers; -1 if its deadline is another. */
    static int place(@Nullable Long deadline) {
        return deadline == null || deadline < RUNNING ? -1 : (int) (deadline - RUNNING);
    }
}
