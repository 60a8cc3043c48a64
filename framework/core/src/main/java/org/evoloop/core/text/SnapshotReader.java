package org.evoloop.core.text;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.function.Supplier;
import org.evoloop.core.Doubt;
import org.evoloop.core.Pending;
import org.evoloop.core.Snapshot;
import org.evoloop.core.Tally;
import org.evoloop.core.Work;
import org.evoloop.evolution.BrokenPlan;
import org.evoloop.evolution.Configuration;
import org.evoloop.evolution.Decision;
import org.evoloop.evolution.ModelPair;
import org.evoloop.evolution.Occurrence;
import org.evoloop.evolution.OnFailure;
import org.evoloop.evolution.Step;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.State;
import org.evoloop.statemachine.Transition;
import org.jspecify.annotations.Nullable;

/** Reads the text that {@link SnapshotWriter} writes, line by line in the same order. */
final class SnapshotReader {
    private final Lines lines;
    private final Names names;
    private final OccurrenceReader occurrences;

    SnapshotReader(ModelPair models, Lines lines) {
        this.lines = lines;
        this.names = new Names(models, lines);
        this.occurrences = new OccurrenceReader(lines, names);
    }

    Snapshot read() {
        version();
        boolean open = truth("open");
        Configuration at = at("at");
        lines.next("sent");
        long steps = lines.total();
        long lastStepNanos = ended(lines.number());
        Snapshot.OpenVisit visit = visit();
        boolean losing = truth("losing");
        boolean owed = truth("owed");
        List<Pending> waiting = many("waiting", this::pending);
        Doubt doubt = doubt();
        Work work = work();
        Tally tally = tally();
        lines.next("now");
        long nowNanos = ended(lines.number());
        lines.next("end");
        lines.endsAll();
        return new Snapshot(open, at, doubt, steps, lastStepNanos, visit, waiting, losing, owed, work, tally, nowNanos);
    }

    private void version() {
        if (!lines.next().equals(SnapshotText.TITLE)) {
            throw lines.wrong("this is not a snapshot of Evoloop; its first line is '" + SnapshotText.TITLE + " "
                    + SnapshotText.VERSION + "'");
        }
        long version = ended(lines.number());
        if (version != SnapshotText.VERSION) {
            throw lines.wrong("version " + version + " cannot be read, only version " + SnapshotText.VERSION
                    + "; use the version of Evoloop that wrote it, or start without it");
        }
    }

    /** Returns {@code value} after checking that its line has ended. */
    private <T> T ended(T value) {
        lines.ends();
        return value;
    }

    private boolean truth(String name) {
        lines.next(name);
        return ended(lines.choice("true", "false"));
    }

    private <T> List<T> many(String name, Supplier<T> one) {
        lines.next(name);
        int count = ended(lines.count());
        List<T> all = new ArrayList<>();
        while (all.size() < count) {
            all.add(one.get());
        }
        return List.copyOf(all);
    }

    private Configuration at(String name) {
        lines.next(name);
        return ended(new Configuration(names.originalState(), names.evolvedState()));
    }

    private Snapshot.OpenVisit visit() {
        lines.next("visit");
        long number = lines.total();
        boolean over = ended(lines.choice("over", "on"));
        Transition by = transition("by");
        Map<Event, Long> deadlines = new LinkedHashMap<>();
        many("deadlines", () -> {
            lines.next("deadline");
            Event event = names.event();
            deadlines.put(event, ended(lines.number()));
            return event;
        });
        return new Snapshot.OpenVisit(number, over, by, deadlines);
    }

    private @Nullable Transition transition(String name) {
        lines.next(name);
        Transition transition = isNone() ? null : names.evolvedTransition();
        lines.ends();
        return transition;
    }

    /** Whether the line says {@code none} instead of a name. */
    private boolean isNone() {
        if (lines.isQuotedNext()) {
            return false;
        }
        String word = lines.word();
        if (!word.equals("none")) {
            throw lines.damaged("'none' was expected, not '" + word + "'");
        }
        return true;
    }

    private @Nullable Step step(String name) {
        lines.next(name);
        String by = lines.word();
        if (by.equals("none")) {
            lines.ends();
            return null;
        }
        if (!by.equals("device") && !by.equals("sent")) {
            throw lines.damaged("'device', 'sent' or 'none' was expected, not '" + by + "'");
        }
        boolean conditional = lines.choice("conditional", "always");
        Transition taken = ended(names.originalTransition());
        return new Step(taken, taken.event().trigger(), by.equals("device"), conditional);
    }

    private Step someStep() {
        Step step = step("step");
        if (step == null) {
            throw lines.damaged("a step is missing");
        }
        return step;
    }

    private Pending pending() {
        lines.next("pending");
        long number = lines.total();
        long stepsBefore = lines.total();
        int attempts = ended(lines.count());
        lines.next("from");
        State from = isNone() ? null : names.originalState();
        lines.ends();
        Step own = step("own");
        BrokenPlan broken = broken();
        return new Pending(number, occurrences.read(), from, own, stepsBefore, attempts, broken);
    }

    private @Nullable BrokenPlan broken() {
        lines.next("broken");
        String first = lines.word();
        if (first.equals("none")) {
            lines.ends();
            return null;
        }
        OnFailure then = constant(first, OnFailure.values());
        State begun = names.originalState();
        String reason = lines.text();
        int count = ended(lines.count());
        List<Step> failed = new ArrayList<>();
        while (failed.size() < count) {
            failed.add(someStep());
        }
        return new BrokenPlan(then, reason, begun, failed);
    }

    private List<Occurrence> meanwhile() {
        return many("meanwhile", occurrences::read);
    }

    private @Nullable Doubt doubt() {
        lines.next("doubt");
        String first = lines.word();
        if (first.equals("none")) {
            lines.ends();
            return null;
        }
        long number = lines.numberIn(first);
        long stepsBefore = lines.number();
        boolean settled = lines.choice("settled", "open");
        String why = ended(lines.text());
        return new Doubt(why, number, someStep(), stepsBefore, meanwhile(), settled);
    }

    private @Nullable Work work() {
        lines.next("work");
        String first = lines.word();
        if (first.equals("none")) {
            lines.ends();
            return null;
        }
        int taken = lines.countIn(first);
        int effectsRun = lines.count();
        Work.Stage stage = constant(lines.word(), Work.Stage.values());
        String failedEffects = ended(lines.text());
        return new Work(pending(), decision(), taken, effectsRun, failedEffects, stage, meanwhile());
    }

    private <E extends Enum<E>> E constant(String word, E[] all) {
        for (E each : all) {
            if (each.name().toLowerCase(Locale.ROOT).equals(word)) {
                return each;
            }
        }
        throw lines.damaged("'" + word + "' is none of " + Arrays.toString(all).toLowerCase(Locale.ROOT));
    }

    private @Nullable Decision decision() {
        lines.next("decision");
        String word = ended(lines.word());
        if (word.equals("none")) {
            return null;
        }
        Configuration before = at("before");
        Configuration after = at("after");
        Transition transition = transition("transition");
        List<Step> steps = many("steps", this::someStep);
        lines.next("effects");
        List<String> effects = ended(lines.texts());
        lines.next("reason");
        String reason = ended(lines.text());
        for (DecisionKind kind : DecisionKind.values()) {
            if (kind.word().equals(word) && (transition != null || !kind.needsTransition())) {
                return kind.made(before, after, steps, transition, effects, reason);
            }
        }
        throw lines.damaged("'" + word + "' is not a decision that could be made here");
    }

    private Tally tally() {
        lines.next("tally");
        return ended(new Tally(
                lines.total(),
                lines.total(),
                lines.total(),
                lines.total(),
                lines.total(),
                lines.total(),
                lines.total(),
                lines.total(),
                lines.count()));
    }
}
