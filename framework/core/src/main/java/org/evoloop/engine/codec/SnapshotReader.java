package org.evoloop.engine.codec;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.evoloop.engine.Doubt;
import org.evoloop.engine.Pending;
import org.evoloop.engine.Snapshot;
import org.evoloop.engine.Tally;
import org.evoloop.engine.Work;
import org.evoloop.evolution.BrokenPlan;
import org.evoloop.evolution.Configuration;
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
    /** A visit goes on or is over; or it goes on, and its function has yet to be started. */
    static final List<String> VISITS = List.of("on", "over", "unstarted");

    /** A doubt is open or settled, by a report if that is still to be decided; with or without an interrupted decision. */
    static final List<String> DOUBTS = List.of("open", "settled", "interrupted", "reported");

    private final Items items;
    private final ElementReader elements;

    SnapshotReader(ModelPair models, Items items) {
        this.items = items;
        this.elements = ElementReader.strict(models, items);
    }

    Snapshot read() {
        boolean open = truth("open");
        Configuration at = elements.at("at");
        items.next("sent");
        long steps = items.total();
        long lastStepNanos = elements.ended(items.number());
        Snapshot.OpenVisit visit = visit();
        boolean losing = truth("losing");
        boolean owed = truth("owed");
        List<Pending> waiting = elements.many("waiting", this::pending);
        Doubt doubt = doubt();
        Work work = work();
        Tally tally = tally();
        items.next("now");
        long nowNanos = elements.ended(items.number());
        items.next("end");
        items.endsAll();
        return new Snapshot(open, at, doubt, steps, lastStepNanos, visit, waiting, losing, owed, work, tally, nowNanos);
    }

    private boolean truth(String name) {
        items.next(name);
        return elements.ended(items.choice("true", "false"));
    }

    private Snapshot.OpenVisit visit() {
        items.next("visit");
        long number = items.total();
        int which = elements.ended(items.choice(VISITS));
        Transition by = elements.transition("by");
        Map<Event, Long> deadlines = new LinkedHashMap<>();
        elements.many("deadlines", () -> {
            items.next("deadline");
            Event event = elements.event();
            deadlines.put(event, elements.ended(items.number()));
            return event;
        });
        return new Snapshot.OpenVisit(number, which == 1, by, deadlines, which == 2);
    }

    private Pending pending() {
        items.next("pending");
        long number = items.total();
        long stepsBefore = items.total();
        int attempts = elements.ended(items.count());
        items.next("from");
        State from = items.isNone() ? null : elements.state();
        items.ends();
        Step own = elements.step("own");
        BrokenPlan broken = broken();
        return new Pending(number, elements.occurrence(), from, own, stepsBefore, attempts, broken);
    }

    private @Nullable BrokenPlan broken() {
        items.next("broken");
        if (items.isNone()) {
            items.ends();
            return null;
        }
        OnFailure then = Constants.ON_FAILURE.read(items);
        State begun = elements.state();
        String reason = items.text();
        int count = elements.ended(items.count());
        List<Step> failed = new ArrayList<>();
        while (failed.size() < count) {
            failed.add(elements.someStep());
        }
        return new BrokenPlan(then, reason, begun, failed);
    }

    private List<Occurrence> meanwhile() {
        return elements.many("meanwhile", elements::occurrence);
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
        String why = elements.ended(items.text());
        Step step = elements.step("step");
        List<Occurrence> meanwhile = meanwhile();
        return new Doubt(
                why, number, step, stepsBefore, meanwhile, which % 2 == 1, which > 1 ? elements.decision() : null);
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
        String failedEffects = elements.ended(items.text());
        return new Work(pending(), elements.decision(), taken, effectsRun, failedEffects, stage, meanwhile());
    }

    private Tally tally() {
        items.next("tally");
        return elements.ended(new Tally(
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
