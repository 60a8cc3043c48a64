package org.evoloop.engine.codec;

import java.util.List;
import java.util.Map;
import org.evoloop.engine.Doubt;
import org.evoloop.engine.Pending;
import org.evoloop.engine.Snapshot;
import org.evoloop.engine.Tally;
import org.evoloop.engine.Work;
import org.evoloop.evolution.BrokenPlan;
import org.evoloop.evolution.Occurrence;
import org.evoloop.statemachine.Event;
import org.jspecify.annotations.Nullable;

/** Writes the items that {@link SnapshotReader} reads, in the same order. */
final class SnapshotWriter {
    private final ItemWriter items;
    private final ElementWriter elements;

    SnapshotWriter(ItemWriter items) {
        this.items = items;
        this.elements = new ElementWriter(items);
    }

    void write(Snapshot snapshot) {
        items.begin("open").truth(snapshot.open()).end();
        elements.at("at", snapshot.at());
        items.begin("sent")
                .number(snapshot.steps())
                .number(snapshot.lastStepNanos())
                .end();
        visit(snapshot.visit());
        items.begin("losing").truth(snapshot.losing()).end();
        items.begin("owed").truth(snapshot.followOwed()).end();
        items.begin("waiting").number(snapshot.waiting().size()).end();
        snapshot.waiting().forEach(this::pending);
        doubt(snapshot.doubt());
        work(snapshot.work());
        tally(snapshot.tally());
        items.begin("now").number(snapshot.nowNanos()).end();
        items.begin("end").end();
    }

    private void visit(Snapshot.OpenVisit visit) {
        items.begin("visit")
                .number(visit.number())
                .choice(visit.startOwed() ? 2 : visit.over() ? 1 : 0, SnapshotReader.VISITS)
                .end();
        elements.transition("by", visit.by());
        items.begin("deadlines").number(visit.deadlines().size()).end();
        for (Map.Entry<Event, Long> deadline : visit.deadlines().entrySet()) {
            items.begin("deadline");
            elements.event(deadline.getKey()).number(deadline.getValue()).end();
        }
    }

    private void pending(Pending pending) {
        items.begin("pending")
                .number(pending.number())
                .number(pending.stepsBefore())
                .number(pending.attempts())
                .end();
        if (pending.from() == null) {
            items.none("from");
        } else {
            items.beginSome("from").name(pending.from().name()).end();
        }
        elements.step("own", pending.own());
        broken(pending.broken());
        elements.occurrence(pending.occurrence());
    }

    private void broken(@Nullable BrokenPlan broken) {
        if (broken == null) {
            items.none("broken");
            return;
        }
        items.beginSome("broken")
                .word(Constants.ON_FAILURE.word(broken.then()))
                .name(broken.begun().name())
                .text(broken.reason())
                .number(broken.failed().size())
                .end();
        elements.steps(broken.failed());
    }

    private void occurrences(List<Occurrence> meanwhile) {
        items.begin("meanwhile").number(meanwhile.size()).end();
        meanwhile.forEach(elements::occurrence);
    }

    private void doubt(@Nullable Doubt doubt) {
        if (doubt == null) {
            items.none("doubt");
            return;
        }
        items.beginSome("doubt")
                .number(doubt.number())
                .number(doubt.stepsBefore())
                .choice((doubt.settled() ? 1 : 0) + (doubt.interrupted() != null ? 2 : 0), SnapshotReader.DOUBTS)
                .text(doubt.why())
                .end();
        elements.step("step", doubt.step());
        occurrences(doubt.meanwhile());
        if (doubt.interrupted() != null) {
            elements.decision(doubt.interrupted());
        }
    }

    private void work(@Nullable Work work) {
        if (work == null) {
            items.none("work");
            return;
        }
        items.beginSome("work")
                .number(work.taken())
                .number(work.effectsRun())
                .word(Constants.STAGES.word(work.stage()))
                .text(work.failedEffects())
                .end();
        pending(work.pending());
        elements.decision(work.decision());
        occurrences(work.meanwhile());
    }

    private void tally(Tally tally) {
        items.begin("tally")
                .number(tally.observed())
                .number(tally.handled())
                .number(tally.ignored())
                .number(tally.stale())
                .number(tally.failed())
                .number(tally.dropped())
                .number(tally.refused())
                .number(tally.queued())
                .number(tally.highest())
                .end();
    }
}
