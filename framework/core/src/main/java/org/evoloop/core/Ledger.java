package org.evoloop.core;

import java.util.HashSet;
import java.util.List;
import java.util.Set;
import org.evoloop.evolution.Configuration;
import org.evoloop.evolution.Decision;
import org.evoloop.evolution.Occurrence;
import org.evoloop.evolution.Source;
import org.evoloop.evolution.Step;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.State;
import org.evoloop.statemachine.Transition;
import org.jspecify.annotations.Nullable;

/** All that a {@link Core} knows, and the entries that more than one of its parts makes. */
final class Ledger {
    final Place place;
    final Line line;
    final Stay stay;
    final Counts counts;
    Rules rules;
    boolean open;

    /** The latest time of any input. */
    long nowNanos;

    /** Whether facts were lost, so that the new model has to follow the device when nothing waits any more. */
    boolean followOwed;

    final Progress progress;

    final Outputs out;

    Ledger(Rules rules, Snapshot snapshot, Outputs out) {
        Snapshot.OpenVisit visit = snapshot.visit();
        this.rules = rules;
        this.out = out;
        this.open = snapshot.open();
        this.nowNanos = snapshot.nowNanos();
        this.place = new Place(snapshot.at(), snapshot.steps(), snapshot.lastStepNanos(), snapshot.doubt());
        this.counts = new Counts(snapshot.tally());
        this.line = new Line(snapshot.waiting(), counts, snapshot.losing());
        this.stay = new Stay(visit.number(), visit.over(), visit.by(), visit.deadlines());
        this.progress = new Progress(snapshot.work());
        this.followOwed = snapshot.followOwed();
    }

    Snapshot snapshot() {
        return new Snapshot(
                open,
                place.at(),
                place.lastDoubt(),
                place.steps(),
                place.lastStepNanos(),
                new Snapshot.OpenVisit(stay.number(), stay.isOver(), stay.by(), stay.inOrder()),
                line.waiting(),
                line.isLosing(),
                followOwed,
                progress.work(),
                counts.tally(),
                nowNanos);
    }

    boolean isDevicesState(State state) {
        return rules.table().models().original().hasState(state);
    }

    /** It is this late at least; what was observed before may be told after. */
    void isAt(long atNanos) {
        nowNanos = Math.max(nowNanos, atNanos);
    }

    // What has become of an occurrence

    void ended(
            Occurrence occurrence, Configuration before, Outcome outcome, @Nullable Decision decision, String detail) {
        counts.end(outcome);
        out.ended(occurrence, before, place.at(), outcome, decision, detail);
    }

    void refused(Occurrence occurrence) {
        counts.refuse();
        out.refused(occurrence);
    }

    // Visits

    void enter(@Nullable Transition by, Set<String> kept) {
        stay.enter(place.at().evolved(), by, kept, rules, nowNanos, out);
    }

    /** Enters the state whose visit was cut off, or goes on in other models: what is left of its timers counts, and what it has raised. */
    void enterAsLeft() {
        Set<String> kept = new HashSet<>();
        for (Event timer : rules.timers().of(place.at().evolved()).keySet()) {
            kept.add(timer.name());
        }
        long before = stay.number();
        for (Pending pending : line.waiting()) {
            if (pending.occurrence() instanceof Occurrence.Heard heard && heard.source() == Source.TIMER) {
                stay.heard(heard.event());
            }
        }
        enter(stay.by(), kept);
        line.replace(pending -> pending.carriedOver(before, stay.number()));
        progress.replace(pending -> pending.carriedOver(before, stay.number()));
    }

    /**
     * Enters the current state anew if its visit has ended without another state being entered; returns whether it has.
     *
     * @param after what has come to its end; when other models have taken over, what is left of the timers counts
     */
    boolean enterAgain(Occurrence after) {
        boolean again = stay.isOver() && open && !line.isRetryNext();
        if (again && after instanceof Occurrence.Evolved) {
            enterAsLeft();
        } else if (again) {
            enter(stay.by(), Set.of());
        }
        return again && !(after instanceof Occurrence.Evolved);
    }

    /** The function of the current state begins, if another visit than {@code before} has begun and the state is new. */
    void start(long before, boolean again) {
        if (stay.number() != before && rules.table().isNew(place.at().evolved())) {
            out.start(stay.number(), again);
        }
    }

    // Doubt

    /** From now on the record is in doubt; the device is asked before anything else is begun. */
    void doubt(String why, long number, Step step, List<Occurrence> meanwhile) {
        long before = place.lastDoubt() == null ? place.steps() : Doubt.UNSETTLED;
        place.doubt(new Doubt(why, number, step, before, meanwhile, false));
        out.doubted(why);
        ask();
    }

    /** Has the device asked if the record is in doubt and that was not seen to yet. */
    void ask() {
        Doubt doubt = place.doubt();
        if (doubt != null && !line.holdsDoubt()) {
            Occurrence occurrence = new Occurrence.InDoubt(doubt.why(), nowNanos);
            line.addFirst(new Pending(counts.observe(), occurrence, null, null, place.steps(), 0));
        }
    }

    void settleDoubt() {
        Doubt doubt = place.doubt();
        if (doubt != null) {
            place.doubt(doubt.settled(true));
            out.doubted("");
        }
    }

    /** What the device does while a step is on its way, or while it is asked where it is, may be older or newer than that. */
    void happensMeanwhile(Occurrence fact) {
        if (progress.mayOverlap()) {
            progress.acted(fact);
        }
        Doubt doubt = place.lastDoubt();
        if (doubt != null) {
            place.doubt(doubt.acted(fact));
        }
    }
}
