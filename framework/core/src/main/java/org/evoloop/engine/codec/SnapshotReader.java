package org.evoloop.engine.codec;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Supplier;
import org.evoloop.engine.Doubt;
import org.evoloop.engine.Pending;
import org.evoloop.engine.Snapshot;
import org.evoloop.engine.Tally;
import org.evoloop.engine.Work;
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

/** Reads the items that {@link SnapshotWriter} writes, in the same order. */
final class SnapshotReader {
    private static final DecisionKind[] KINDS = DecisionKind.values();

    /** A visit goes on or is over; or it goes on, and its function has yet to be started. */
    static final List<String> VISITS = List.of("on", "over", "unstarted");

    /** A doubt is open or settled, by a report if that is still to be decided; with or without an interrupted decision. */
    static final List<String> DOUBTS = List.of("open", "settled", "interrupted", "reported");

    private final Items items;
    private final Names names;
    private final OccurrenceReader occurrences;

    SnapshotReader(ModelPair models, Items items) {
        this.items = items;
        this.names = new Names(models, items);
        this.occurrences = new OccurrenceReader(items, names);
    }

    Snapshot read() {
        boolean open = truth("open");
        Configuration at = at("at");
        items.next("sent");
        long steps = items.total();
        long lastStepNanos = ended(items.number());
        Snapshot.OpenVisit visit = visit();
        boolean losing = truth("losing");
        boolean owed = truth("owed");
        List<Pending> waiting = many("waiting", this::pending);
        Doubt doubt = doubt();
        Work work = work();
        Tally tally = tally();
        items.next("now");
        long nowNanos = ended(items.number());
        items.next("end");
        items.endsAll();
        return new Snapshot(open, at, doubt, steps, lastStepNanos, visit, waiting, losing, owed, work, tally, nowNanos);
    }

    /** Returns {@code value} after checking that its line has ended. */
    private <T> T ended(T value) {
        items.ends();
        return value;
    }

    private boolean truth(String name) {
        items.next(name);
        return ended(items.choice("true", "false"));
    }

    private <T> List<T> many(String name, Supplier<T> one) {
        items.next(name);
        int count = ended(items.count());
        if (count == 0) {
            return List.of();
        }
        List<T> all = new ArrayList<>();
        while (all.size() < count) {
            all.add(one.get());
        }
        return List.copyOf(all);
    }

    private Configuration at(String name) {
        items.next(name);
        return ended(new Configuration(names.originalState(), names.evolvedState()));
    }

    private Snapshot.OpenVisit visit() {
        items.next("visit");
        long number = items.total();
        int which = ended(items.choice(VISITS));
        Transition by = transition("by");
        Map<Event, Long> deadlines = new LinkedHashMap<>();
        many("deadlines", () -> {
            items.next("deadline");
            Event event = names.event();
            deadlines.put(event, ended(items.number()));
            return event;
        });
        return new Snapshot.OpenVisit(number, which == 1, by, deadlines, which == 2);
    }

    private @Nullable Transition transition(String name) {
        items.next(name);
        Transition transition = items.isNone() ? null : names.evolvedTransition();
        items.ends();
        return transition;
    }

    private @Nullable Step step(String name) {
        items.next(name);
        if (items.isNone()) {
            items.ends();
            return null;
        }
        boolean byDevice = items.choice("device", "sent");
        boolean conditional = items.choice("conditional", "always");
        Transition taken = ended(names.originalTransition());
        return new Step(taken, taken.event().trigger(), byDevice, conditional);
    }

    private Step someStep() {
        Step step = step("step");
        if (step == null) {
            throw items.damaged("a step is missing");
        }
        return step;
    }

    private Pending pending() {
        items.next("pending");
        long number = items.total();
        long stepsBefore = items.total();
        int attempts = ended(items.count());
        items.next("from");
        State from = items.isNone() ? null : names.originalState();
        items.ends();
        Step own = step("own");
        BrokenPlan broken = broken();
        return new Pending(number, occurrences.read(), from, own, stepsBefore, attempts, broken);
    }

    private @Nullable BrokenPlan broken() {
        items.next("broken");
        if (items.isNone()) {
            items.ends();
            return null;
        }
        OnFailure then = Constants.ON_FAILURE.read(items);
        State begun = names.originalState();
        String reason = items.text();
        int count = ended(items.count());
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
        items.next("doubt");
        if (items.isNone()) {
            items.ends();
            return null;
        }
        long number = items.number();
        long stepsBefore = items.number();
        int which = items.choice(DOUBTS);
        String why = ended(items.text());
        Step step = step("step");
        List<Occurrence> meanwhile = meanwhile();
        return new Doubt(why, number, step, stepsBefore, meanwhile, which % 2 == 1, which > 1 ? decision() : null);
    }

    private @Nullable Work work() {
        items.next("work");
        if (items.isNone()) {
            items.ends();
            return null;
        }
        int taken = items.count();
        int effectsRun = items.count();
        Work.Stage stage = Constants.STAGES.read(items);
        String failedEffects = ended(items.text());
        return new Work(pending(), decision(), taken, effectsRun, failedEffects, stage, meanwhile());
    }

    private @Nullable Decision decision() {
        items.next("decision");
        if (items.isNone()) {
            items.ends();
            return null;
        }
        String word = ended(items.word());
        Configuration before = at("before");
        Configuration after = at("after");
        Transition transition = transition("transition");
        List<Step> steps = many("steps", this::someStep);
        items.next("effects");
        List<String> effects = ended(items.texts());
        items.next("reason");
        String reason = ended(items.text());
        for (DecisionKind kind : KINDS) {
            if (kind.word().equals(word) && (transition != null || !kind.needsTransition())) {
                return kind.made(before, after, steps, transition, effects, reason);
            }
        }
        throw items.damaged("'" + word + "' is not a decision that could be made here");
    }

    private Tally tally() {
        items.next("tally");
        return ended(new Tally(
                items.total(),
                items.total(),
                items.total(),
                items.total(),
                items.total(),
                items.total(),
                items.total(),
                items.total(),
                items.count()));
    }
}
