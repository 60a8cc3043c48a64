package org.evoloop.engine.codec;

import java.util.List;
import java.util.Map;
import java.util.Set;
import org.evoloop.engine.Doubt;
import org.evoloop.engine.Pending;
import org.evoloop.engine.Snapshot;
import org.evoloop.engine.Tally;
import org.evoloop.engine.Work;
import org.evoloop.evolution.BrokenPlan;
import org.evoloop.evolution.Configuration;
import org.evoloop.evolution.Decision;
import org.evoloop.evolution.Occurrence;
import org.evoloop.evolution.Step;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.Transition;
import org.jspecify.annotations.Nullable;

/** Writes the items that {@link SnapshotReader} reads, in the same order. */
final class SnapshotWriter {
    private final ItemWriter items;

    SnapshotWriter(ItemWriter items) {
        this.items = items;
    }

    void write(Snapshot snapshot) {
        items.begin("open").truth(snapshot.open()).end();
        at("at", snapshot.at());
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

    private void at(String name, Configuration at) {
        items.begin(name).text(at.original().name()).text(at.evolved().name()).end();
    }

    private void visit(Snapshot.OpenVisit visit) {
        items.begin("visit")
                .number(visit.number())
                .choice(visit.startOwed() ? 2 : visit.over() ? 1 : 0, SnapshotReader.VISITS)
                .end();
        transition("by", visit.by());
        items.begin("deadlines").number(visit.deadlines().size()).end();
        for (Map.Entry<Event, Long> deadline : visit.deadlines().entrySet()) {
            items.begin("deadline");
            event(deadline.getKey()).number(deadline.getValue()).end();
        }
    }

    private ItemWriter event(Event event) {
        return items.text(event.name()).texts(event.guards());
    }

    private void transition(String name, @Nullable Transition transition) {
        if (transition == null) {
            items.none(name);
        } else {
            items.beginSome(name);
            arc(transition).end();
        }
    }

    private ItemWriter arc(Transition transition) {
        items.text(transition.source().name());
        event(transition.event());
        return items.text(transition.target().name());
    }

    private void step(String name, @Nullable Step step) {
        if (step == null) {
            items.none(name);
        } else {
            items.beginSome(name)
                    .choice(step.byDevice(), "device", "sent")
                    .choice(step.conditional(), "conditional", "always");
            arc(step.transition()).end();
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
            items.beginSome("from").text(pending.from().name()).end();
        }
        step("own", pending.own());
        broken(pending.broken());
        occurrence(pending.occurrence());
    }

    private void broken(@Nullable BrokenPlan broken) {
        if (broken == null) {
            items.none("broken");
            return;
        }
        items.beginSome("broken")
                .word(Constants.ON_FAILURE.word(broken.then()))
                .text(broken.begun().name())
                .text(broken.reason())
                .number(broken.failed().size())
                .end();
        broken.failed().forEach(step -> step("step", step));
    }

    private void occurrence(Occurrence occurrence) {
        if (occurrence instanceof Occurrence.Heard heard) {
            kind("heard", occurrence)
                    .number(heard.visit())
                    .word(Constants.SOURCES.word(heard.source()))
                    .choice(heard.deviceActed(), "acted", "told");
            event(heard.event()).texts(sorted(heard.holding()));
            values(occurrence);
        } else if (occurrence instanceof Occurrence.Asked asked) {
            kind("asked", occurrence).number(asked.visit());
            event(asked.event());
            values(occurrence);
        } else if (occurrence instanceof Occurrence.Found found) {
            kind("found", occurrence).text(found.state().name());
        } else if (occurrence instanceof Occurrence.InDoubt inDoubt) {
            kind("in-doubt", occurrence).text(inDoubt.why());
        } else if (occurrence instanceof Occurrence.Violated violated) {
            kind("violated", occurrence).text(violated.property());
        } else if (occurrence instanceof Occurrence.Evolved evolved) {
            kind("evolved", occurrence).text(evolved.model());
        }
        items.end();
    }

    private ItemWriter kind(String word, Occurrence occurrence) {
        return items.beginKind(word).number(occurrence.observedNanos());
    }

    private static List<String> sorted(Set<String> texts) {
        return texts.isEmpty() ? List.of() : texts.stream().sorted().toList();
    }

    private void values(Occurrence occurrence) {
        Map<String, Object> values = occurrence.values().byName();
        items.number(values.size());
        values.forEach((name, value) -> items.text(name).value(value));
    }

    private void occurrences(List<Occurrence> meanwhile) {
        items.begin("meanwhile").number(meanwhile.size()).end();
        meanwhile.forEach(this::occurrence);
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
        step("step", doubt.step());
        occurrences(doubt.meanwhile());
        if (doubt.interrupted() != null) {
            decision(doubt.interrupted());
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
        decision(work.decision());
        occurrences(work.meanwhile());
    }

    private void decision(@Nullable Decision decision) {
        if (decision == null) {
            items.none("decision");
            return;
        }
        items.beginSome("decision").word(DecisionKind.of(decision).word()).end();
        at("before", decision.before());
        at("after", decision.after());
        transition("transition", decision.transition());
        items.begin("steps").number(decision.steps().size()).end();
        decision.steps().forEach(step -> step("step", step));
        items.begin("effects").texts(decision.effects()).end();
        items.begin("reason").text(DecisionKind.reasonOf(decision)).end();
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
