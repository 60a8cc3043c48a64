package org.evoloop.engine;

import java.math.BigDecimal;
import java.util.Locale;
import org.evoloop.evolution.DeviceEvents;
import org.evoloop.evolution.Occurrence;
import org.evoloop.evolution.Outcome;
import org.evoloop.evolution.Source;
import org.evoloop.evolution.Step;
import org.evoloop.evolution.Values;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.Names;
import org.evoloop.statemachine.State;
import org.jspecify.annotations.Nullable;

/** The part of a core by which occurrences come in, wait, and get their turn. */
final class Arrivals {
    private static final String VIOLATED = "an assumption about time did not hold";
    private static final String LEFT = "the state that raised it has been left";
    private static final String OVERTAKEN = "the device has been sent an event since";

    private final Ledger ledger;
    private final Conversion conversion;

    // The message for the last event that neither model knows, and the rules by which; not part of the state.
    private @Nullable Event lastUnknown;
    private @Nullable Rules unknownIn;
    private String unknown = "";

    Arrivals(Ledger ledger, Conversion conversion) {
        this.ledger = ledger;
        this.conversion = conversion;
    }

    void observed(Occurrence occurrence) {
        ledger.isAt(occurrence.observedNanos());
        if (occurrence instanceof Occurrence.Found found) {
            find(found);
        } else if (occurrence instanceof Occurrence.Violated) {
            endAtOnce(occurrence, Outcome.FAILED, VIOLATED);
        } else if (occurrence instanceof Occurrence.Heard heard) {
            hear(heard);
        } else {
            askedFor(occurrence);
        }
    }

    /** Takes a request, only while the converter is open. */
    private void askedFor(Occurrence occurrence) {
        if (ledger.open) {
            enqueue(occurrence, null, null);
        } else {
            ledger.counts.observe();
            ledger.refused(occurrence);
        }
    }

    /** The device has acted: the record follows at once, whatever is waiting or being sent. */
    private void follow(Occurrence.Heard fact) {
        State from = ledger.place.at().original();
        Step own = ledger.rules.table().ownStep(from, fact.event(), fact.holding()::contains);
        boolean impossible = own == null && ledger.rules.table().isImpossible(from, fact.event());
        ledger.happensMeanwhile(fact);
        ledger.out.acted(fact, from, own);
        if (own != null) {
            ledger.place.moveDevice(own.target(), ledger.out);
        }
        enqueue(fact, from, own);
        if (impossible && !ledger.progress.isSending()) {
            contradict(fact, from);
        }
    }

    /**
     * The device has done what it cannot do in its recorded state: it has been elsewhere. If what it did leads to one
     * state only, it is there now, as far as anybody knows.
     */
    private void contradict(Occurrence.Heard fact, State from) {
        State likely = ledger.rules.table().onlyTarget(fact.event());
        if (likely != null) {
            ledger.place.moveDevice(likely, ledger.out);
        }
        ledger.followOwed = true;
        ledger.contradicted(fact, from);
    }

    private void find(Occurrence.Found found) {
        if (!ledger.isDevicesState(found.state())) {
            endAtOnce(
                    found,
                    Outcome.FAILED,
                    "the device was found in " + Names.shown(found.state().name())
                            + ", which is not a state of its model"
                            + Names.hint(
                                    found.state().name(),
                                    ledger.rules.table().models().original().states()));
        } else if (ledger.place.isOld(found)) {
            endAtOnce(found, Outcome.STALE, OVERTAKEN);
        } else {
            Doubt doubt = ledger.place.doubt();
            ledger.out.reported(found.state(), ledger.place.at().original());
            boolean completes = ledger.completed(doubt, found.state()) != null;
            ledger.happensMeanwhile(found);
            ledger.settleDoubt();
            Doubt settled = ledger.place.lastDoubt();
            if (doubt != null && settled != null && completes) {
                ledger.place.doubt(settled.reported(doubt.interrupted()));
            }
            if (completes || !ledger.place.isNoNews(found)) {
                State from = ledger.place.at().original();
                ledger.place.moveDevice(found.state(), ledger.out);
                enqueue(found, from, null);
            } else if (doubt != null) {
                ledger.followIfApart();
            }
            // A function may have waited only for this certainty.
            ledger.start(ledger.stay.number(), false);
        }
    }

    private void endAtOnce(Occurrence occurrence, Outcome outcome, String detail) {
        ledger.counts.observe();
        ledger.ended(occurrence, ledger.place.at(), outcome, null, detail);
    }

    void timerDue(long visit, Event event, long atNanos) {
        ledger.isAt(atNanos);
        if (ledger.open
                && ledger.stay.isCurrent(visit)
                && !ledger.stay.isOver()
                && ledger.stay.isDue(event, ledger.nowNanos)) {
            hear(new Occurrence.Heard(event, Values.NONE, Source.TIMER, visit, ledger.nowNanos));
        }
    }

    /** An event that only the device can take, such as a time trigger of its own model, has already been taken. */
    private void hear(Occurrence.Heard heard) {
        boolean own = ledger.rules.table().isDevicesOwn(heard.event().trigger());
        if (!ledger.rules.table().names().knows(heard.event()) && (ledger.open || heard.deviceActed())) {
            if (heard.deviceActed()) {
                ledger.out.acted(heard, ledger.place.at().original(), null);
            }
            // It would have no effect, and must not take up room needed by facts.
            endAtOnce(heard, Outcome.IGNORED, unknown(heard.event()));
        } else if (heard.deviceActed() || (own && heard.source() != Source.CONTROLLER)) {
            follow(heard);
        } else if (own && ledger.open) {
            endAtOnce(heard, Outcome.IGNORED, DeviceEvents.notPressed(heard.event()));
        } else {
            askedFor(heard);
        }
    }

    /** A misspelt event comes again and again, and the search for similar names is slow. */
    private String unknown(Event event) {
        if (!event.equals(lastUnknown) || !ledger.rules.equals(unknownIn)) {
            lastUnknown = event;
            unknownIn = ledger.rules;
            unknown = ledger.rules.table().names().unknown(event);
        }
        return unknown;
    }

    private void enqueue(Occurrence occurrence, @Nullable State from, @Nullable Step own) {
        long number = ledger.counts.observe();
        Pending next = new Pending(number, occurrence, from, own, ledger.place.steps(), 0);
        if (ledger.mailbox.hasRoom(next, ledger.rules, ledger.progress.isIdle())) {
            ledger.mailbox.add(next);
            ledger.out.queued(occurrence);
        } else {
            ledger.followOwed |= next.hasHappened();
            ledger.counts.end(Outcome.DROPPED);
            ledger.out.dropped(occurrence, ledger.mailbox.lose());
        }
    }

    void ready() {
        if (ledger.open && ledger.progress.isInterrupted()) {
            resume(ledger.progress.pending());
        }
        while (ledger.progress.isIdle() && ledger.open) {
            Pending next = owedFinding();
            if (next == null) {
                next = ledger.mailbox.next();
            }
            if (next == null) {
                return;
            }
            giveTurn(next);
        }
    }

    /** See {@link Core#upcoming}. */
    @Nullable
    Pending upcoming() {
        if (ledger.progress.isInterrupted() && mayResume(ledger.progress.pending())) {
            return ledger.progress.pending();
        }
        boolean owed = ledger.followOwed
                && ledger.mailbox.first(pending -> pending.hasHappened() && mayBegin(pending)) == null;
        return owed ? finding(0) : ledger.mailbox.first(this::mayBegin);
    }

    private boolean mayBegin(Pending pending) {
        // A visit that is over is followed by another before anything new has its turn.
        boolean outlived = ledger.stay.isOver()
                && pending.attempts() == 0
                && ledger.stay.isCurrent(pending.occurrence().visit());
        return !outlived && outOfDate(pending).isEmpty() && !ledger.rules.isTooOld(pending, ledger.nowNanos);
    }

    /**
     * An interrupted plan goes on, unless it would send something for a press that has become too old meanwhile, or the
     * function that asked for it has ended.
     */
    private void resume(Pending pending) {
        if (mayResume(pending)) {
            ledger.progress.resume();
            ledger.out.begin(pending);
        } else {
            Outcome outcome = ledger.progress.stepsSent() == 0 ? Outcome.STALE : Outcome.FAILED;
            conversion.conclude(pending.number(), outcome, isOfAnotherVisit(pending) ? LEFT : age(pending));
        }
    }

    private boolean mayResume(Pending pending) {
        return !isTooOldToResume(pending) && !isOfAnotherVisit(pending);
    }

    private boolean isOfAnotherVisit(Pending pending) {
        long visit = pending.occurrence().visit();
        return visit != Occurrence.ANY_VISIT && !ledger.stay.isCurrent(visit);
    }

    private boolean isTooOldToResume(Pending pending) {
        return ledger.rules.isTooOld(pending, ledger.nowNanos) && ledger.progress.step() != null;
    }

    /** For people. */
    private String age(Pending pending) {
        double seconds = (ledger.nowNanos - pending.occurrence().observedNanos()) / 1e9;
        return String.format(
                Locale.ROOT,
                "pressed %.0f s before its turn; the limit is %s s",
                seconds,
                BigDecimal.valueOf(ledger.rules.pressAge().toMillis(), 3)
                        .stripTrailingZeros()
                        .toPlainString());
    }

    /** See {@link Core#hasRoom}. */
    boolean hasRoom(Occurrence raised) {
        Pending next = new Pending(0, raised, null, null, ledger.place.steps(), 0);
        return ledger.mailbox.hasRoomForFunction(next, ledger.rules, ledger.progress.isIdle());
    }

    /**
     * Has the new model follow to the device's state without having heard how the device got there; null if it need
     * not, or if facts wait from which it still hears.
     */
    private @Nullable Pending owedFinding() {
        if (!ledger.followOwed || ledger.mailbox.holdsFacts()) {
            return null;
        }
        ledger.followOwed = false;
        return finding(ledger.counts.observe());
    }

    private Pending finding(long number) {
        State there = ledger.place.at().original();
        return new Pending(number, new Occurrence.Found(there, ledger.nowNanos), there, null, ledger.place.steps(), 0);
    }

    private void giveTurn(Pending pending) {
        Occurrence occurrence = pending.occurrence();
        String outOfDate = outOfDate(pending);
        if (!outOfDate.isEmpty()) {
            Outcome outcome = occurrence instanceof Occurrence.InDoubt ? Outcome.HANDLED : Outcome.STALE;
            long visit = ledger.stay.number();
            ledger.ended(occurrence, ledger.place.at(), outcome, null, outOfDate);
            // It may be what the end of the present visit has waited for.
            ledger.start(visit, ledger.enterAgain(occurrence));
            return;
        }
        if (occurrence instanceof Occurrence.Heard heard && heard.source() == Source.TIMER) {
            ledger.stay.heard(heard.event());
        }
        ledger.progress.begin(pending);
        if (ledger.rules.isTooOld(pending, ledger.nowNanos)) {
            conversion.conclude(pending.number(), Outcome.STALE, age(pending));
        } else {
            ledger.out.begin(pending);
        }
    }

    /** Why it ends as soon as it has its turn; empty if it does not. */
    private String outOfDate(Pending pending) {
        if (isOfAnotherVisit(pending)) {
            return LEFT;
        }
        boolean found = pending.occurrence() instanceof Occurrence.InDoubt && ledger.place.doubt() == null;
        return found ? Conversion.FOUND_MEANWHILE : "";
    }
}
