package org.evoloop.core;

import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import org.evoloop.evolution.Configuration;
import org.evoloop.evolution.Decision;
import org.evoloop.evolution.Occurrence;
import org.evoloop.evolution.Step;
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

    /** Whether facts were lost, so that the new model has to follow the device when nothing waits any more. */
    boolean followOwed;

    /** The occurrence in progress; null if there is none. */
    @Nullable
    Work work;

    /** Where the outputs of the current input go. */
    List<Output> out = new ArrayList<>();

    Ledger(Rules rules, Snapshot snapshot) {
        Snapshot.Visit visit = snapshot.visit();
        this.rules = rules;
        this.open = snapshot.open();
        this.place = new Place(snapshot.at(), snapshot.steps(), snapshot.lastStepNanos(), snapshot.doubt());
        this.counts = new Counts(snapshot.tally());
        this.line = new Line(snapshot.waiting(), counts, snapshot.losing());
        this.stay = new Stay(visit.number(), visit.over(), visit.by(), visit.deadlines());
        this.work = snapshot.work();
        this.followOwed = snapshot.followOwed();
    }

    Snapshot snapshot() {
        return new Snapshot(
                open,
                place.at(),
                place.lastDoubt(),
                place.steps(),
                place.lastStepNanos(),
                new Snapshot.Visit(stay.number(), stay.isOver(), stay.by(), stay.inOrder()),
                line.waiting(),
                line.isLosing(),
                followOwed,
                work,
                counts.tally());
    }

    /** The occurrence in progress if it is the one of this number; null if that was given up. */
    @Nullable
    Work inProgress(long number) {
        Work current = work;
        return current != null && current.pending().number() == number ? current : null;
    }

    boolean isDevicesState(State state) {
        return rules.table().models().original().hasState(state);
    }

    // What has become of an occurrence

    void ended(
            Occurrence occurrence, Configuration before, Outcome outcome, @Nullable Decision decision, String detail) {
        counts.end(outcome);
        out.add(new Output.Ended(occurrence, before, place.at(), outcome, decision, detail));
    }

    void refused(Occurrence occurrence) {
        counts.refuse();
        out.add(new Output.Refused(occurrence));
    }

    // Visits

    void enter(@Nullable Transition by, Set<String> kept, long atNanos) {
        stay.enter(place.at().evolved(), by, kept, rules, atNanos, out);
    }

    /** Enters the current state anew if its visit has ended without another state being entered. */
    void enterAgain(long atNanos) {
        if (stay.isOver() && open && !line.isRetryNext()) {
            enter(stay.by(), Set.of(), atNanos);
        }
    }

    /** The function of the current state begins, if another visit than {@code before} has begun and the state is new. */
    void start(long before) {
        if (stay.number() != before && rules.table().models().isNew(place.at().evolved())) {
            out.add(new Output.Start(stay.number()));
        }
    }

    // Doubt

    /** From now on the record is in doubt; the device is asked before anything else is begun. */
    void doubt(String why, Work during, Step step, long atNanos) {
        long before = place.lastDoubt() == null ? place.steps() : Doubt.UNSETTLED;
        place.doubt(new Doubt(why, during.pending().number(), step, before, during.meanwhile(), false));
        out.add(new Output.Doubted(why));
        ask(atNanos);
    }

    /** Has the device asked if the record is in doubt and that was not seen to yet. */
    void ask(long atNanos) {
        Doubt doubt = place.doubt();
        if (doubt != null && !line.holdsDoubt()) {
            Occurrence occurrence = new Occurrence.InDoubt(doubt.why(), atNanos);
            line.addFirst(new Pending(counts.observe(), occurrence, null, null, place.steps(), 0));
        }
    }

    void settleDoubt() {
        Doubt doubt = place.doubt();
        if (doubt != null) {
            place.doubt(doubt.settled(true));
            out.add(new Output.Doubted(""));
        }
    }

    /** What the device does while a step is on its way, or while it is asked where it is, may be older or newer than that. */
    void happensMeanwhile(Occurrence fact) {
        Work current = work;
        if (current != null && (current.sending() || current.decision() instanceof Decision.Inquiry)) {
            work = current.acted(fact);
        }
        Doubt doubt = place.lastDoubt();
        if (doubt != null) {
            place.doubt(doubt.acted(fact));
        }
    }
}
