package org.evoloop.engine;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.evoloop.evolution.Configuration;
import org.evoloop.evolution.Decision;
import org.evoloop.evolution.Occurrence;
import org.evoloop.evolution.Step;
import org.evoloop.statemachine.Event;
import org.jspecify.annotations.Nullable;

/** Copies of snapshots with one change. */
final class Snapshots {
    private Snapshots() {}

    static Snapshot at(Snapshot of, Configuration at) {
        return made(of, at, of.doubt(), of.visit(), of.waiting(), of.followOwed(), of.work(), of.tally());
    }

    static Snapshot sure(Snapshot of) {
        return made(of, of.at(), null, of.visit(), of.waiting(), of.followOwed(), of.work(), of.tally());
    }

    static Snapshot visit(Snapshot of, Snapshot.OpenVisit visit) {
        return made(of, of.at(), of.doubt(), visit, of.waiting(), of.followOwed(), of.work(), of.tally());
    }

    static Snapshot waiting(Snapshot of, List<Pending> waiting) {
        return made(of, of.at(), of.doubt(), of.visit(), waiting, of.followOwed(), of.work(), of.tally());
    }

    static Snapshot work(Snapshot of, @Nullable Work work) {
        return made(of, of.at(), of.doubt(), of.visit(), of.waiting(), of.followOwed(), work, of.tally());
    }

    static Snapshot tally(Snapshot of, Tally tally) {
        return made(of, of.at(), of.doubt(), of.visit(), of.waiting(), of.followOwed(), of.work(), tally);
    }

    /** As if one more occurrence had been observed, and lost. */
    static Snapshot lost(Snapshot of) {
        Tally tally = of.tally();
        return tally(
                of,
                new Tally(
                        tally.observed() + 1,
                        tally.handled(),
                        tally.ignored(),
                        tally.stale(),
                        tally.failed(),
                        tally.dropped() + 1,
                        tally.refused(),
                        tally.queued(),
                        tally.highest()));
    }

    /** The step to be sent next, or being sent; null if none is left. */
    static @Nullable Step nextStep(Work work) {
        Decision decision = work.decision();
        return decision != null && work.taken() < decision.steps().size()
                ? decision.steps().get(work.taken())
                : null;
    }

    /** As if its next step had not been announced. */
    static Work notSent(Work of) {
        return new Work(
                of.pending(),
                of.decision(),
                of.taken(),
                of.effectsRun(),
                of.failedEffects(),
                Work.Stage.READY,
                List.of());
    }

    static Snapshot systemStays(Snapshot before, Snapshot after) {
        return at(after, after.at().withEvolved(before.at().evolved()));
    }

    static Work begun(Pending pending) {
        return new Work(pending, null, 0, 0, "", Work.Stage.READY, List.of());
    }

    static Work asking(Pending pending, Snapshot before) {
        return new Work(pending, new Decision.Inquiry(before.at()), 0, 0, "", Work.Stage.READY, List.of());
    }

    static Snapshot.OpenVisit due(Snapshot.OpenVisit of, Map<Event, Long> deadlines) {
        return new Snapshot.OpenVisit(of.number(), of.over(), of.by(), deadlines, of.startOwed());
    }

    /** Whether it sends the device to where other models need it, which have taken over. */
    static boolean isOfOtherModels(@Nullable Work work) {
        return work != null && work.pending().occurrence() instanceof Occurrence.Evolved;
    }

    static Snapshot.OpenVisit owingNoStart(Snapshot.OpenVisit of) {
        return new Snapshot.OpenVisit(of.number(), of.over(), of.by(), of.deadlines(), false);
    }

    static Snapshot forgettingItsDecision(Snapshot of) {
        Doubt doubt = of.doubt();
        Doubt forgetful = doubt == null
                ? null
                : new Doubt(
                        doubt.why(),
                        doubt.number(),
                        doubt.step(),
                        doubt.stepsBefore(),
                        doubt.meanwhile(),
                        doubt.settled(),
                        null);
        return made(of, of.at(), forgetful, of.visit(), of.waiting(), of.followOwed(), of.work(), of.tally());
    }

    /** The copy in which everything that waits belongs to this visit. */
    static Snapshot allOf(Snapshot of, long visit) {
        return waiting(
                of, of.waiting().stream().map(pending -> of(pending, visit)).toList());
    }

    private static Pending of(Pending pending, long visit) {
        if (pending.occurrence() instanceof Occurrence.Heard heard && heard.visit() != Occurrence.ANY_VISIT) {
            Occurrence moved =
                    new Occurrence.Heard(heard.event(), heard.values(), heard.source(), visit, heard.observedNanos());
            return new Pending(
                    pending.number(), moved, pending.from(), pending.own(), pending.stepsBefore(), pending.attempts());
        }
        return pending;
    }

    static Snapshot followOwed(Snapshot of, boolean owed) {
        return made(of, of.at(), of.doubt(), of.visit(), of.waiting(), owed, of.work(), of.tally());
    }

    private static Snapshot made(
            Snapshot of,
            Configuration at,
            @Nullable Doubt doubt,
            Snapshot.OpenVisit visit,
            List<Pending> waiting,
            boolean owed,
            @Nullable Work work,
            Tally tally) {
        return new Snapshot(
                of.open(),
                at,
                doubt,
                of.steps(),
                of.lastStepNanos(),
                visit,
                waiting,
                of.losing(),
                owed,
                work,
                tally,
                of.nowNanos());
    }

    static Snapshot without(Snapshot snapshot, List<Pending> hidden) {
        List<Pending> left = new ArrayList<>(snapshot.waiting());
        left.removeAll(hidden);
        return waiting(snapshot, left);
    }

    static Snapshot with(Snapshot snapshot, List<Pending> hidden) {
        List<Pending> all = new ArrayList<>(snapshot.waiting());
        all.addAll(hidden);
        return waiting(snapshot, all);
    }
}
