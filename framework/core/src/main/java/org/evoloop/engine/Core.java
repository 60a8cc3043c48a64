package org.evoloop.engine;

import java.util.List;
import java.util.Map;
import java.util.Set;
import org.evoloop.evolution.Configuration;
import org.evoloop.evolution.Decision;
import org.evoloop.evolution.Occurrence;
import org.evoloop.evolution.Step;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.State;
import org.jspecify.annotations.Nullable;

/**
 * The deterministic core of a converter, which turns inputs into outputs.
 *
 * <p>Occurrences wait in one queue and are handled one at a time: begun, decided, carried out step by step, ended.
 * Facts come first: what the device did by itself moves the record when it is observed; only the new model's reaction
 * waits for its turn, and is decided from the record at that time. A plan overtaken by a fact is decided again, so that
 * nothing is ever sent from a state in which the device no longer is.
 *
 * <p>Its parts share one {@link Ledger}, the state: {@link Arrivals} take occurrences in and give them their turn,
 * {@link Conversion} carries out the one in progress, {@link Takeover} lets other models take over.
 *
 * <p>Threading: not thread-safe; the caller gives it one input after another.
 *
 * @since 0.1
 */
public final class Core implements Inputs {
    private final Ledger ledger;
    private final Arrivals arrivals;
    private final Conversion conversion;
    private final Takeover takeover;

    /** A converter that has not been opened yet, in the initial states of its models. */
    public Core(Rules rules, Outputs outputs) {
        this(rules, outputs, 0);
    }

    /**
     * A new one whose visits continue the numbering of a former one.
     *
     * @param visits the number of the last visit; 0 if there was none
     */
    public Core(Rules rules, Outputs outputs, long visits) {
        this(rules, fresh(rules, visits), outputs);
    }

    /** Continues from {@code snapshot}, by the {@code rules} that applied when it was taken. */
    public Core(Rules rules, Snapshot snapshot, Outputs outputs) {
        this.ledger = new Ledger(rules, snapshot, outputs);
        this.conversion = new Conversion(ledger);
        this.arrivals = new Arrivals(ledger, conversion);
        this.takeover = new Takeover(ledger);
    }

    /** Continues from {@code snapshot} instead, as a new core would: for programs that run very many converters. */
    public void restore(Rules rules, Snapshot snapshot) {
        ledger.restore(rules, snapshot);
    }

    private static Snapshot fresh(Rules rules, long visits) {
        return new Snapshot(
                false,
                rules.table().models().initial(),
                null,
                0,
                0,
                new Snapshot.OpenVisit(visits, true, null, Map.of(), false),
                List.of(),
                false,
                false,
                null,
                new Tally(0, 0, 0, 0, 0, 0, 0, 0, 0),
                0);
    }

    /** Its complete state. */
    public Snapshot snapshot() {
        return ledger.snapshot();
    }

    // Inputs about the converter as a whole

    @Override
    public void opened(long atNanos) {
        ledger.isAt(atNanos);
        long visit = ledger.stay.number();
        ledger.open = true;
        ledger.ask();
        if (conversion.isLeaving()) {
            return;
        }
        // A visit that has not ended was cut off, not closed.
        boolean cutOff = !ledger.stay.isOver();
        ledger.stay.leave(ledger.out);
        if (cutOff) {
            ledger.enterAsLeft();
        } else {
            ledger.enter(ledger.stay.by(), Set.of());
        }
        ledger.start(visit, false);
    }

    @Override
    public void recovered(long atNanos) {
        ledger.isAt(atNanos);
        ledger.open = false;
        conversion.interrupt();
    }

    @Override
    public void closing() {
        if (!ledger.open) {
            // A plan that was interrupted by the end of the process waits until the converter is opened again.
            return;
        }
        ledger.open = false;
        conversion.dropInterrupted();
        for (Pending pending : ledger.mailbox.withoutFacts()) {
            ledger.refused(pending.occurrence());
        }
    }

    @Override
    public void closed() {
        ledger.stay.leave(ledger.out);
    }

    @Override
    public void changed(Rules rules, long atNanos) {
        ledger.isAt(atNanos);
        ledger.becomes(rules);
        // Another component may know what the previous one did not.
        ledger.ask();
    }

    @Override
    public void evolved(Swap swap, long atNanos) {
        ledger.isAt(atNanos);
        takeover.take(swap);
    }

    // Inputs about occurrences

    @Override
    public void observed(Occurrence occurrence) {
        arrivals.observed(occurrence);
    }

    @Override
    public void timerDue(long visit, Event event, long atNanos) {
        arrivals.timerDue(visit, event, atNanos);
    }

    @Override
    public void ready() {
        arrivals.ready();
    }

    @Override
    public void planned(long number, Decision decision, long atNanos) {
        conversion.planned(number, decision, atNanos);
    }

    @Override
    public void dismissed(long number, long atNanos) {
        conversion.dismissed(number, atNanos);
    }

    @Override
    public void sending(long number) {
        conversion.sending(number);
    }

    @Override
    public void sent(long number, boolean inOrder, long atNanos) {
        conversion.sent(number, inOrder, atNanos);
    }

    @Override
    public void running(long number) {
        conversion.running(number);
    }

    @Override
    public void effectRun(long number, String failure, long atNanos) {
        conversion.effectRun(number, failure, atNanos);
    }

    @Override
    public void located(long number, @Nullable State state, long atNanos) {
        conversion.located(number, state, atNanos);
    }

    @Override
    public void failed(long number, String reason, long atNanos) {
        conversion.failed(number, reason, atNanos);
    }

    @Override
    public void givenUp(long number, String reason, long atNanos) {
        conversion.givenUp(number, reason, atNanos);
    }

    // What it tells

    /**
     * What {@link #ready} would begin when nothing is in progress and the converter is open; null if that is nothing.
     * Its number is 0 if it has not been observed yet.
     */
    public @Nullable Pending upcoming() {
        return arrivals.upcoming();
    }

    /** Whether a function may raise this event without waiting. Controllers' events do not matter for that. */
    public boolean hasRoom(Occurrence raised) {
        return arrivals.hasRoom(raised);
    }

    /** What prevents the models of {@code swap} from taking over now, for people; empty if nothing does. */
    public String hindrance(Swap swap) {
        return takeover.hindrance(swap);
    }

    /** Refuses an occurrence that has not been observed and cannot be taken in any state of the converter. */
    public void refuse(Occurrence occurrence) {
        ledger.counts.observe();
        ledger.refused(occurrence);
    }

    /** The decision whose plan is resumed; null if the occurrence in progress is to be decided as usual. */
    public @Nullable Decision resumed() {
        return ledger.progress.isResumed() ? ledger.progress.decision() : null;
    }

    /** The states of device and evolved system. */
    public Configuration at() {
        return ledger.place.at();
    }

    /** How many steps have been sent and have had their effect. */
    public long steps() {
        return ledger.place.steps();
    }

    /** Why the record may be wrong; empty if it is certain. */
    public String doubt() {
        Doubt doubt = ledger.place.doubt();
        return doubt == null ? "" : doubt.why();
    }

    /** The step of which it is unknown whether the device has taken it; null if there is none. */
    public @Nullable Step doubtfulStep() {
        Doubt doubt = ledger.place.doubt();
        return doubt == null ? null : doubt.step();
    }

    /** The latest time of any input. */
    public long nowNanos() {
        return ledger.nowNanos;
    }

    /** Its present rules. */
    public Rules rules() {
        return ledger.rules;
    }

    /** The number of the current visit. */
    public long visit() {
        return ledger.stay.number();
    }

    /** When the timers of the current visit are due, without those that have fired; empty if it has ended. */
    public Map<Event, Long> deadlines() {
        return ledger.stay.isOver() ? Map.of() : ledger.stay.inOrder();
    }

    /** Whether the current visit has ended, with all that ran in it, and the next has not begun. */
    public boolean isVisitOver() {
        return ledger.stay.isOver();
    }

    /** Whether the requested step may be sent: it was announced, and nothing has overtaken it. */
    public boolean maySend(long number) {
        return ledger.progress.isOf(number) && ledger.progress.isSending();
    }

    /** Whether controllers' events are taken. */
    public boolean isOpen() {
        return ledger.open;
    }

    /** Whether an occurrence is in progress. */
    public boolean isBusy() {
        return !ledger.progress.isIdle();
    }

    /** Whether the plan in progress was interrupted by the end of a process, and waits until the converter is open. */
    public boolean isInterrupted() {
        return ledger.progress.isInterrupted();
    }

    /** Whether an occurrence is ready to begin when nothing is in progress. */
    public boolean hasNext() {
        return ledger.mailbox.size() > 0 || ledger.followOwed || ledger.progress.isInterrupted();
    }

    /** How many occurrences wait for their turn. */
    public int waiting() {
        return ledger.mailbox.size();
    }

    /** The number of occurrences and their outcomes. */
    public Tally tally() {
        return ledger.counts.tally();
    }
}
