package org.evoloop.core.text;

import java.util.Collection;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import org.evoloop.core.Doubt;
import org.evoloop.core.Pending;
import org.evoloop.core.Snapshot;
import org.evoloop.core.Tally;
import org.evoloop.core.Work;
import org.evoloop.evolution.BrokenPlan;
import org.evoloop.evolution.Configuration;
import org.evoloop.evolution.Decision;
import org.evoloop.evolution.Occurrence;
import org.evoloop.evolution.Step;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.Transition;
import org.jspecify.annotations.Nullable;

/** Writes the text that {@link SnapshotReader} reads, line by line in the same order. */
final class SnapshotWriter {
    /** Large enough for most snapshots. */
    private static final int CAPACITY = 512;

    private final StringBuilder text = new StringBuilder(CAPACITY);

    String write(Snapshot snapshot) {
        begin(SnapshotText.TITLE).word(SnapshotText.VERSION).end();
        begin("open").word(snapshot.open()).end();
        at("at", snapshot.at());
        begin("sent").word(snapshot.steps()).word(snapshot.lastStepNanos()).end();
        visit(snapshot.visit());
        begin("losing").word(snapshot.losing()).end();
        begin("owed").word(snapshot.followOwed()).end();
        begin("waiting").word(snapshot.waiting().size()).end();
        snapshot.waiting().forEach(this::pending);
        doubt(snapshot.doubt());
        work(snapshot.work());
        tally(snapshot.tally());
        begin("now").word(snapshot.nowNanos()).end();
        begin("end").end();
        return text.toString();
    }

    private SnapshotWriter begin(String first) {
        text.append(first);
        return this;
    }

    private SnapshotWriter word(long number) {
        text.append(' ').append(number);
        return this;
    }

    private SnapshotWriter word(boolean truth) {
        text.append(' ').append(truth);
        return this;
    }

    private SnapshotWriter word(String word) {
        text.append(' ').append(word);
        return this;
    }

    private SnapshotWriter word(Enum<?> constant) {
        return word(constant.name().toLowerCase(Locale.ROOT));
    }

    private SnapshotWriter quoted(String words) {
        text.append(' ');
        Quoted.append(text, words);
        return this;
    }

    private void end() {
        text.append('\n');
    }

    private void none(String name) {
        begin(name).word("none").end();
    }

    private void at(String name, Configuration at) {
        begin(name).quoted(at.original().name()).quoted(at.evolved().name()).end();
    }

    private void visit(Snapshot.OpenVisit visit) {
        begin("visit").word(visit.number()).word(visit.over() ? "over" : "on").end();
        transition("by", visit.by());
        begin("deadlines").word(visit.deadlines().size()).end();
        for (Map.Entry<Event, Long> deadline : visit.deadlines().entrySet()) {
            begin("deadline").event(deadline.getKey()).word(deadline.getValue()).end();
        }
    }

    private SnapshotWriter event(Event event) {
        return quoted(event.name()).texts(event.guards());
    }

    private SnapshotWriter texts(Collection<String> texts) {
        word(texts.size());
        texts.forEach(this::quoted);
        return this;
    }

    private void transition(String name, @Nullable Transition transition) {
        if (transition == null) {
            none(name);
        } else {
            begin(name).arc(transition).end();
        }
    }

    private SnapshotWriter arc(Transition transition) {
        return quoted(transition.source().name())
                .event(transition.event())
                .quoted(transition.target().name());
    }

    private void step(String name, @Nullable Step step) {
        if (step == null) {
            none(name);
        } else {
            begin(name)
                    .word(step.byDevice() ? "device" : "sent")
                    .word(step.conditional() ? "conditional" : "always")
                    .arc(step.transition())
                    .end();
        }
    }

    private void pending(Pending pending) {
        begin("pending")
                .word(pending.number())
                .word(pending.stepsBefore())
                .word(pending.attempts())
                .end();
        if (pending.from() == null) {
            none("from");
        } else {
            begin("from").quoted(pending.from().name()).end();
        }
        step("own", pending.own());
        broken(pending.broken());
        occurrence(pending.occurrence());
    }

    private void broken(@Nullable BrokenPlan broken) {
        if (broken == null) {
            none("broken");
            return;
        }
        begin("broken")
                .word(broken.then())
                .quoted(broken.begun().name())
                .quoted(broken.reason())
                .word(broken.failed().size())
                .end();
        broken.failed().forEach(step -> step("step", step));
    }

    private void occurrence(Occurrence occurrence) {
        if (occurrence instanceof Occurrence.Heard heard) {
            begin("heard")
                    .word(heard.observedNanos())
                    .word(heard.visit())
                    .word(heard.source())
                    .word(heard.deviceActed() ? "acted" : "told")
                    .event(heard.event())
                    .texts(heard.holding().stream().sorted().toList())
                    .values(occurrence);
        } else if (occurrence instanceof Occurrence.Asked asked) {
            begin("asked")
                    .word(asked.observedNanos())
                    .word(asked.visit())
                    .event(asked.event())
                    .values(occurrence);
        } else if (occurrence instanceof Occurrence.Found found) {
            begin("found").word(found.observedNanos()).quoted(found.state().name());
        } else if (occurrence instanceof Occurrence.InDoubt inDoubt) {
            begin("in-doubt").word(inDoubt.observedNanos()).quoted(inDoubt.why());
        } else if (occurrence instanceof Occurrence.Violated violated) {
            begin("violated").word(violated.observedNanos()).quoted(violated.property());
        } else if (occurrence instanceof Occurrence.Evolved evolved) {
            begin("evolved").word(evolved.observedNanos()).quoted(evolved.model());
        }
        end();
    }

    private void values(Occurrence occurrence) {
        Map<String, Object> values = occurrence.values().byName();
        word(values.size());
        values.forEach((name, value) -> {
            quoted(name);
            if (value instanceof String words) {
                quoted(words);
            } else {
                word(value.toString());
            }
        });
    }

    private void occurrences(List<Occurrence> meanwhile) {
        begin("meanwhile").word(meanwhile.size()).end();
        meanwhile.forEach(this::occurrence);
    }

    private void doubt(@Nullable Doubt doubt) {
        if (doubt == null) {
            none("doubt");
            return;
        }
        begin("doubt")
                .word(doubt.number())
                .word(doubt.stepsBefore())
                .word(doubt.settled() ? "settled" : "open")
                .quoted(doubt.why())
                .end();
        step("step", doubt.step());
        occurrences(doubt.meanwhile());
    }

    private void work(@Nullable Work work) {
        if (work == null) {
            none("work");
            return;
        }
        begin("work")
                .word(work.taken())
                .word(work.effectsRun())
                .word(work.stage())
                .quoted(work.failedEffects())
                .end();
        pending(work.pending());
        decision(work.decision());
        occurrences(work.meanwhile());
    }

    private void decision(@Nullable Decision decision) {
        if (decision == null) {
            none("decision");
            return;
        }
        begin("decision").word(DecisionKind.of(decision).word()).end();
        at("before", decision.before());
        at("after", decision.after());
        transition("transition", decision.transition());
        begin("steps").word(decision.steps().size()).end();
        decision.steps().forEach(step -> step("step", step));
        begin("effects").texts(decision.effects()).end();
        begin("reason").quoted(DecisionKind.reasonOf(decision)).end();
    }

    private void tally(Tally tally) {
        begin("tally")
                .word(tally.observed())
                .word(tally.handled())
                .word(tally.ignored())
                .word(tally.stale())
                .word(tally.failed())
                .word(tally.dropped())
                .word(tally.refused())
                .word(tally.queued())
                .word(tally.highest())
                .end();
    }
}
