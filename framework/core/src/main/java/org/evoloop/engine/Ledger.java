package org.evoloop.engine;

import java.util.HashSet;
import java.util.List;
import java.util.Set;
import org.evoloop.evolution.Configuration;
import org.evoloop.evolution.Decision;
import org.evoloop.evolution.Occurrence;
import org.evoloop.evolution.Outcome;
import org.evoloop.evolution.Source;
import org.evoloop.evolution.Step;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.State;
import org.evoloop.statemachine.Transition;
import org.jspecify.annotations.Nullable;

/** The state of a {@link Core}, and the changes that several of its parts make. */
final class Ledger {
    final Place place;
    final Mailbox mailbox;
    final Stay stay;
    final Counts counts;
    Rules rules;
    boolean open;

    /** The latest time of any input. */
    long nowNanos;

    /**
     * Whether the new model has to follow the device once no fact waits any more, since facts alone do not lead it
     * there: some were lost, were decided only after a step, or are older than the device's own answer; a step had its
     * effect after it was given up; other models have taken over that do not have the two states together; or something
     * has ended with the device elsewhere than the new model's state needs it.
     */
    boolean followOwed;

    final Progress progress;

    final Outputs out;

    Ledger(Rules rules, Snapshot snapshot, Outputs out) {
        this.out = out;
        this.rules = rules;
        this.place = new Place(snapshot);
        this.counts = new Counts(snapshot.tally());
        this.mailbox = new Mailbox(snapshot, counts, this::isDeferred, this::isUrgent);
        this.stay = new Stay(snapshot.visit());
        this.progress = new Progress(snapshot.work());
        restore(rules, snapshot);
    }

    void restore(Rules otherRules, Snapshot snapshot) {
        rules = otherRules;
        open = snapshot.open();
        nowNanos = snapshot.nowNanos();
        followOwed = snapshot.followOwed();
        place.restore(snapshot);
        counts.restore(snapshot.tally());
        mailbox.restore(snapshot);
        stay.restore(snapshot.visit());
        progress.restore(snapshot.work());
    }

    Snapshot snapshot() {
        return new Snapshot(
                open,
                place.at(),
                place.lastDoubt(),
                place.steps(),
                place.lastStepNanos(),
                stay.visit(),
                mailbox.waiting(),
                mailbox.isLosing(),
                followOwed,
                progress.work(),
                counts.tally(),
                nowNanos);
    }

    boolean isDevicesState(State state) {
        return rules.table().models().original().hasState(state);
    }

    /** Whether the new model's state defers an event. Facts are never deferred. */
    private boolean isDeferred(Pending pending) {
        return !pending.hasHappened()
                && pending.occurrence() instanceof Occurrence.Heard heard
                && rules.table().defers(place.at(), heard.event());
    }

    private boolean isUrgent(Pending pending) {
        return rules.isUrgent(pending);
    }

    /** Other rules apply from now on. */
    void becomes(Rules others) {
        rules = others;
        // What is urgent may be another.
        mailbox.replace(pending -> pending);
    }

    /**
     * Why the occurrence in progress has to make way for an urgent event, for people; empty if there is none, or the new
     * model would not take it where it is.
     */
    String overtakenBy() {
        Pending urgent = progress.isIdle() || isUrgent(progress.pending()) ? null : nextUrgent();
        return urgent == null ? "" : urgent.occurrence().label() + " came, which is urgent";
    }

    private @Nullable Pending nextUrgent() {
        if (!mailbox.holdsUrgent()) {
            return null;
        }
        return mailbox.firstUrgent(pending ->
                rules.table().models().evolved().hasTrigger(place.at().evolved(), trigger(pending))
                        && (pending.occurrence().visit() == Occurrence.ANY_VISIT
                                || stay.isCurrent(pending.occurrence().visit())));
    }

    private static Event trigger(Pending urgent) {
        return ((Occurrence.Heard) urgent.occurrence()).event().trigger();
    }

    /** Advances the time; earlier observations may still be reported later. */
    void isAt(long atNanos) {
        nowNanos = Math.max(nowNanos, atNanos);
    }

    /** Whether the device is where the new model's state needs it. */
    private boolean isWhereNeeded() {
        return rules.table().isWhereNeeded(place.at());
    }

    /** Whether the new model has yet to hear what the device did, or to follow it out of a state that needs it. */
    boolean isToFollowFirst() {
        return mailbox.holdsFacts() || (followOwed && !isWhereNeeded());
    }

    // Outcomes

    void ended(
            Occurrence occurrence, Configuration before, Outcome outcome, @Nullable Decision decision, String detail) {
        counts.end(outcome);
        followUnless(isWhereNeeded());
        String why = decision instanceof Decision.NotAcceptable
                ? rules.table().models().guardsThatDoNotHold(before, occurrence)
                : detail;
        out.ended(occurrence, before, place.at(), outcome, decision, why);
    }

    void refused(Occurrence occurrence) {
        counts.refuse();
        out.refused(occurrence);
    }

    // Visits

    /** No function runs while the device is sent to where the new model is: the state is entered after that. */
    void enter(@Nullable Transition by, Set<String> kept) {
        stay.prepare(place.at().evolved(), by, kept, rules, nowNanos);
        if (!isSettling()) {
            stay.enter(place.at().evolved(), out);
        }
    }

    /**
     * Enters again the state whose visit was cut off or continues in other models: it keeps the remaining time of its
     * timers, and the events that it raised.
     */
    void enterAsLeft() {
        Set<String> kept = new HashSet<>();
        for (Event timer : rules.timers().of(place.at().evolved()).keySet()) {
            kept.add(timer.name());
        }
        long before = stay.number();
        for (Pending pending : mailbox.waiting()) {
            // An older one is stale, and this visit's may still come.
            if (pending.occurrence() instanceof Occurrence.Heard heard
                    && heard.source() == Source.TIMER
                    && heard.visit() == before) {
                stay.heard(heard.event());
            }
        }
        enter(stay.by(), kept);
        mailbox.replace(pending -> pending.carriedOver(before, stay.number()));
        progress.replace(pending -> pending.carriedOver(before, stay.number()));
    }

    /** Whether the device has yet to be sent to where the new model is, after other models have taken over. */
    boolean isSettling() {
        return mailbox.holdsTakeover()
                || (!progress.isIdle() && progress.pending().occurrence() instanceof Occurrence.Evolved);
    }

    /**
     * Enters the current state anew if its visit has ended without another state being entered; returns whether it has.
     * Where the device is elsewhere than the state needs it, the new model follows instead; an urgent event is decided
     * before that.
     *
     * @param after the occurrence that has ended; after a takeover the timers keep their remaining time, unless they had
     *     to wait until the device was where the state needs it
     */
    boolean enterAgain(Occurrence after) {
        boolean again = stay.isOver()
                && open
                && !mailbox.isRetryNext()
                && nextUrgent() == null
                && !isSettling()
                && isWhereNeeded();
        boolean tookOver = after instanceof Occurrence.Evolved;
        if (again && tookOver && !rules.table().needsDevice(place.at().evolved())) {
            enterAsLeft();
        } else if (again) {
            enter(stay.by(), Set.of());
        }
        return again && !tookOver;
    }

    /**
     * Starts the function of the current state, if a visit other than {@code before} has begun and the state is new. If
     * the state needs the device somewhere, it is started once the device is certainly there, no fact waits, and the
     * converter is open.
     */
    void start(long before, boolean again) {
        State state = place.at().evolved();
        boolean begins = stay.number() != before && rules.table().isNew(state);
        if (begins && !rules.table().needsDevice(state)) {
            out.start(stay.number(), again);
            return;
        }
        stay.oweStart(begins || stay.isStartOwed());
        if (stay.isStartOwed() && open && isWhereNeeded() && place.doubt() == null && !mailbox.holdsFacts()) {
            stay.oweStart(false);
            out.start(stay.number(), again);
        }
    }

    // Doubt

    /** Puts the record in doubt; the device is asked before anything else begins. */
    void doubt(String why, long number, Step step, List<Occurrence> meanwhile, @Nullable Decision interrupted) {
        long before = place.lastDoubt() == null ? place.steps() : Doubt.UNSETTLED;
        place.doubt(new Doubt(why, number, step, before, meanwhile, false, interrupted));
        out.doubted(why);
        ask();
    }

    /** Queues an inquiry to the device if the record is in doubt and none is queued yet. */
    void ask() {
        Doubt doubt = place.doubt();
        if (doubt != null && !mailbox.holdsDoubt()) {
            Occurrence occurrence = new Occurrence.InDoubt(doubt.why(), nowNanos);
            mailbox.addFirst(new Pending(counts.observe(), occurrence, null, null, place.steps(), 0));
        }
    }

    /** The device has reported {@code fact}, which it cannot have done in {@code from}: the record is wrong. */
    void contradicted(Occurrence fact, State from) {
        String why = "the device reports " + fact.label() + ", which is impossible in " + from;
        if (place.doubt() == null) {
            place.doubt(Doubt.contradicted(place.lastDoubt(), why));
            out.doubted(why);
            ask();
        }
    }

    void settleDoubt() {
        Doubt doubt = place.doubt();
        if (doubt != null) {
            place.doubt(doubt.step() == null ? null : doubt.settled(true));
            out.doubted("");
        }
    }

    /**
     * What a doubt has interrupted is decided anew if the device is in {@code state}, which is where that leads: the
     * transition is taken after all, and nothing is sent. Null if the device is elsewhere, or the new model has moved
     * since.
     */
    @Nullable
    Decision completed(@Nullable Doubt doubt, State state) {
        Decision interrupted = doubt == null ? null : doubt.interrupted();
        if (interrupted == null
                || !place.at().evolved().equals(interrupted.before().evolved())) {
            return null;
        }
        Configuration before = place.at().withOriginal(state);
        Configuration after = interrupted.after().withOriginal(state);
        Transition transition = interrupted.transition();
        if (transition == null || !rules.table().isWhereNeeded(after)) {
            return null;
        }
        return new Decision.NewState(before, after, List.of(), transition, interrupted.effects());
    }

    /** The device is certainly where the record has it, which does not mean that the new model has a place there. */
    void followIfApart() {
        followUnless(rules.table().isFollowed(place.at()));
    }

    /**
     * Where device and new model are apart, the new model follows, unless what was in doubt waits to be decided again: that
     * may have brought the device there, and would otherwise be taken for another press.
     */
    private void followUnless(boolean together) {
        Doubt last = place.lastDoubt();
        followOwed |= !together && (last == null || !mailbox.holds(last.number()));
    }

    /**
     * Notes a fact that came while a step was being sent or the device was being asked: it may be older or newer than
     * that.
     */
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
