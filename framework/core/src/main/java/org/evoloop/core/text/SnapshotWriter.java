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

/** Writes what {@link SnapshotReader} reads, line by line in the same order. */
final class SnapshotWriter {
    /** Most snapshots fit. */
    private static final int CAPACITY = 512;

    private final StringBuilder text = new StringBuilder(CAPACITY);

    String write(Snapshot snapshot) {
        line(SnapshotText.TITLE, SnapshotText.VERSION);
        line("open", snapshot.open());
        at("at", snapshot.at());
        line("sent", snapshot.steps(), snapshot.lastStepNanos());
        visit(snapshot.visit());
        line("losing", snapshot.losing());
        line("owed", snapshot.followOwed());
        line("waiting", snapshot.waiting().size());
        snapshot.waiting().forEach(this::pending);
        doubt(snapshot.doubt());
        work(snapshot.work());
        tally(snapshot.tally());
        line("now", snapshot.nowNanos());
        line("end");
        return text.toString();
    }

    /** Texts are quoted, all else is written as it is. */
    private void line(String first, Object... more) {
        text.append(first);
        for (Object word : more) {
            word(word);
        }
        text.append('\n');
    }

    private void word(Object word) {
        text.append(' ');
        if (word instanceof Quoted quoted) {
            text.append(quoted.inQuotes());
        } else {
            text.append(word);
        }
    }

    private void at(String name, Configuration at) {
        line(name, new Quoted(at.original().name()), new Quoted(at.evolved().name()));
    }

    private void visit(Snapshot.OpenVisit visit) {
        line("visit", visit.number(), visit.over() ? "over" : "on");
        transition("by", visit.by());
        line("deadlines", visit.deadlines().size());
        for (Map.Entry<Event, Long> deadline : visit.deadlines().entrySet()) {
            text.append("deadline");
            event(deadline.getKey());
            word(deadline.getValue());
            text.append('\n');
        }
    }

    private void event(Event event) {
        word(new Quoted(event.name()));
        texts(event.guards());
    }

    private void texts(Collection<String> texts) {
        word(texts.size());
        texts.forEach(one -> word(new Quoted(one)));
    }

    private void transition(String name, @Nullable Transition transition) {
        text.append(name);
        if (transition == null) {
            word("none");
        } else {
            arc(transition);
        }
        text.append('\n');
    }

    private void arc(Transition transition) {
        word(new Quoted(transition.source().name()));
        event(transition.event());
        word(new Quoted(transition.target().name()));
    }

    private void step(String name, @Nullable Step step) {
        text.append(name);
        if (step == null) {
            word("none");
        } else {
            word(step.byDevice() ? "device" : "sent");
            word(step.conditional() ? "conditional" : "always");
            arc(step.transition());
        }
        text.append('\n');
    }

    private void pending(Pending pending) {
        line("pending", pending.number(), pending.stepsBefore(), pending.attempts());
        if (pending.from() == null) {
            line("from", "none");
        } else {
            line("from", new Quoted(pending.from().name()));
        }
        step("own", pending.own());
        broken(pending.broken());
        occurrence(pending.occurrence());
    }

    private void broken(@Nullable BrokenPlan broken) {
        if (broken == null) {
            line("broken", "none");
            return;
        }
        line(
                "broken",
                broken.then().name().toLowerCase(Locale.ROOT),
                new Quoted(broken.begun().name()),
                new Quoted(broken.reason()),
                broken.failed().size());
        broken.failed().forEach(step -> step("step", step));
    }

    private void occurrence(Occurrence occurrence) {
        if (occurrence instanceof Occurrence.Heard heard) {
            text.append("heard");
            word(heard.observedNanos());
            word(heard.visit());
            word(heard.source().name().toLowerCase(Locale.ROOT));
            word(heard.deviceActed() ? "acted" : "told");
            event(heard.event());
            texts(heard.holding().stream().sorted().toList());
            values(occurrence);
        } else if (occurrence instanceof Occurrence.Asked asked) {
            text.append("asked");
            word(asked.observedNanos());
            word(asked.visit());
            event(asked.event());
            values(occurrence);
        } else if (occurrence instanceof Occurrence.Found found) {
            text.append("found");
            word(found.observedNanos());
            word(new Quoted(found.state().name()));
        } else if (occurrence instanceof Occurrence.InDoubt inDoubt) {
            text.append("in-doubt");
            word(inDoubt.observedNanos());
            word(new Quoted(inDoubt.why()));
        } else if (occurrence instanceof Occurrence.Violated violated) {
            text.append("violated");
            word(violated.observedNanos());
            word(new Quoted(violated.property()));
        } else if (occurrence instanceof Occurrence.Evolved evolved) {
            text.append("evolved");
            word(evolved.observedNanos());
            word(new Quoted(evolved.model()));
        }
        text.append('\n');
    }

    private void values(Occurrence occurrence) {
        Map<String, Object> values = occurrence.values().byName();
        word(values.size());
        values.forEach((name, value) -> {
            word(new Quoted(name));
            word(value instanceof String words ? new Quoted(words) : value);
        });
    }

    private void occurrences(List<Occurrence> meanwhile) {
        line("meanwhile", meanwhile.size());
        meanwhile.forEach(this::occurrence);
    }

    private void doubt(@Nullable Doubt doubt) {
        if (doubt == null) {
            line("doubt", "none");
            return;
        }
        line(
                "doubt",
                doubt.number(),
                doubt.stepsBefore(),
                doubt.settled() ? "settled" : "open",
                new Quoted(doubt.why()));
        step("step", doubt.step());
        occurrences(doubt.meanwhile());
    }

    private void work(@Nullable Work work) {
        if (work == null) {
            line("work", "none");
            return;
        }
        line(
                "work",
                work.taken(),
                work.effectsRun(),
                work.stage().name().toLowerCase(Locale.ROOT),
                new Quoted(work.failedEffects()));
        pending(work.pending());
        decision(work.decision());
        occurrences(work.meanwhile());
    }

    private void decision(@Nullable Decision decision) {
        if (decision == null) {
            line("decision", "none");
            return;
        }
        line("decision", DecisionKind.of(decision).word());
        at("before", decision.before());
        at("after", decision.after());
        transition("transition", decision.transition());
        line("steps", decision.steps().size());
        decision.steps().forEach(step -> step("step", step));
        text.append("effects");
        texts(decision.effects());
        text.append('\n');
        line("reason", new Quoted(DecisionKind.reasonOf(decision)));
    }

    private void tally(Tally tally) {
        line(
                "tally",
                tally.observed(),
                tally.handled(),
                tally.ignored(),
                tally.stale(),
                tally.failed(),
                tally.dropped(),
                tally.refused(),
                tally.queued(),
                tally.highest());
    }
}
