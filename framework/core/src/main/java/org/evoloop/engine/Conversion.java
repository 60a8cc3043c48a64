package org.evoloop.engine;

import java.util.List;
import java.util.Objects;
import java.util.Set;
import org.evoloop.evolution.BrokenPlan;
import org.evoloop.evolution.Configuration;
import org.evoloop.evolution.Decision;
import org.evoloop.evolution.DecisionTable;
import org.evoloop.evolution.Occurrence;
import org.evoloop.evolution.Outcome;
import org.evoloop.evolution.Step;
import org.evoloop.statemachine.State;
import org.evoloop.statemachine.Transition;
import org.jspecify.annotations.Nullable;

/** The part of a core by which the occurrence in progress is carried out, step by step, and ends. */
final class Conversion {
    static final String FOUND_MEANWHILE = "the device was found meanwhile";

    private static final String DISMISSED = "dismissed";
    private static final String PROCESS_ENDED = "the converter's process ended meanwhile";

    /** How often the device may overtake the plans for one occurrence. */
    static final int MOST_ATTEMPTS = 8;

    private final Ledger ledger;
    private final Progress progress;

    Conversion(Ledger ledger) {
        this.ledger = ledger;
        this.progress = ledger.progress;
    }

    void planned(long number, Decision decision, long atNanos) {
        ledger.isAt(atNanos);
        if (progress.isOf(number) && progress.isResumed()) {
            progress.proceed();
            proceed();
            return;
        }
        if (!progress.isOf(number) || progress.decision() != null) {
            return;
        }
        if (!decision.startsIn(ledger.place.at())) {
            again("it was decided at " + decision.start());
            return;
        }
        Pending pending = progress.pending();
        if (!pending.goesFirst() && ledger.isToFollowFirst()) {
            again(pending, "what the device did by itself is heard first");
            return;
        }
        String overtaken = pending.hasHappened() ? "" : ledger.overtakenBy();
        if (!overtaken.isEmpty()) {
            giveWay(pending, overtaken);
            return;
        }
        Decision decided = reported(pending, decision);
        ledger.out.decided(
                pending, decided, ledger.nowNanos - pending.occurrence().observedNanos());
        decide(decided);
    }

    /**
     * A report of the device's state may complete what was interrupted, as its answer does. The question that it has
     * answered beforehand decides nothing.
     */
    private Decision reported(Pending pending, Decision usual) {
        Doubt last = ledger.place.lastDoubt();
        if (last == null || !last.isReported() || pending.occurrence() instanceof Occurrence.InDoubt) {
            return usual;
        }
        ledger.place.doubt(last.settled(true));
        Decision completed = ledger.completed(last, ledger.place.at().original());
        boolean isReport =
                pending.occurrence() instanceof Occurrence.Found && usual instanceof Decision.Resynchronization;
        return completed != null && isReport ? completed : usual;
    }

    private void decide(Decision decision) {
        if (decision.leavesState()) {
            // Before the first step leaves: a function that still moved the device would contradict it.
            ledger.stay.leave(ledger.out);
        }
        progress.decide(decision);
        proceed();
    }

    private void proceed() {
        Step step = progress.step();
        String effect = progress.effect();
        if (progress.decision() instanceof Decision.Inquiry) {
            ledger.out.locate();
        } else if (step != null) {
            ledger.out.send(step);
        } else if (effect != null) {
            ledger.out.run(effect);
        } else {
            arrive();
        }
    }

    void sending(long number) {
        Step step = progress.isOf(number) && !progress.isSending() ? progress.step() : null;
        if (step == null) {
            return;
        }
        String overtaken = ledger.overtakenBy();
        if (!overtaken.isEmpty()) {
            conclude(number, Outcome.OVERTAKEN, progress.pending().afterBroken(overtaken));
        } else if (!step.source().equals(ledger.place.at().original())) {
            again("the device left " + step.source() + " by itself");
        } else if (ledger.mailbox.holdsDoubt()) {
            again("the device has to be asked first where it is");
        } else {
            progress.send();
        }
    }

    void sent(long number, boolean inOrder, long atNanos) {
        ledger.isAt(atNanos);
        Step step = stepOnItsWay(number);
        if (step == null) {
            tookLate(number, inOrder, atNanos);
            return;
        }
        List<Occurrence> meanwhile = progress.meanwhile();
        State target = step.target();
        boolean sure = true;
        if (!meanwhile.isEmpty()) {
            // As reported, the step came last.
            DecisionTable table = ledger.rules.table();
            State from = ledger.place.at().original();
            target = Overlap.takes(table, from, step);
            sure = inOrder
                    ? !Overlap.isGuarded(table, from, step)
                    : Overlap.alwaysEndsIn(target, table, step, meanwhile);
        }
        ledger.place.took(target, atNanos, ledger.out);
        ledger.out.took(step);
        progress.took();
        if (!sure || !target.equals(step.target())) {
            again("the device acted by itself while " + step.trigger() + " was sent");
        } else {
            proceed();
        }
        if (!sure) {
            String why = inOrder
                    ? "it is unknown what the device did on " + step.trigger() + ", since that is up to its guards"
                    : "it is unknown whether the device acted before or after it took " + step.trigger();
            ledger.doubt(why, number, step, meanwhile, null);
        } else {
            contradictIfImpossible(step.source(), step, meanwhile, inOrder);
        }
    }

    /** @param step the step that the device took meanwhile, as far as is known; null if it took none */
    private void contradictIfImpossible(
            State start, @Nullable Step step, List<Occurrence> meanwhile, boolean stepLast) {
        Occurrence impossible = Overlap.impossible(ledger.rules.table(), start, step, meanwhile, stepLast);
        if (impossible != null) {
            ledger.followOwed = true;
            ledger.contradicted(impossible, start);
        }
    }

    private @Nullable Step stepOnItsWay(long number) {
        return progress.isOf(number) && progress.isSending() ? progress.step() : null;
    }

    /** A step that was given up has had its effect after all; that settles the doubt if the order is known. */
    private void tookLate(long number, boolean inOrder, long atNanos) {
        Doubt doubt = ledger.place.lastDoubt();
        if (doubt == null) {
            return;
        }
        Step step = doubt.number() == number ? doubt.step() : null;
        State target = step == null
                ? null
                : Overlap.takes(ledger.rules.table(), ledger.place.at().original(), step);
        if (step != null && target != null && isOrderKnown(inOrder, doubt, step, target)) {
            ledger.settleDoubt();
            ledger.place.doubt(doubt.stepsBefore() == Doubt.UNSETTLED ? ledger.place.lastDoubt() : null);
            ledger.place.took(target, atNanos, ledger.out);
            ledger.out.took(step);
            ledger.followOwed = true;
            if (progress.isSending()) {
                // For the step being sent, the device did this beforehand.
                progress.acted(new Occurrence.Found(target, atNanos));
            }
        } else if (doubt.settled()) {
            ledger.place.doubt(doubt.settled(false));
            ledger.out.doubted(doubt.why());
            ledger.ask();
        }
    }

    private boolean isOrderKnown(boolean inOrder, Doubt doubt, Step step, State target) {
        if (inOrder && Overlap.isGuarded(ledger.rules.table(), ledger.place.at().original(), step)) {
            return false;
        } else if (inOrder) {
            return doubt.settled() || doubt.stepsBefore() == ledger.place.steps();
        }
        return doubt.stepsBefore() == ledger.place.steps()
                && !progress.isSending()
                && Overlap.alwaysEndsIn(target, ledger.rules.table(), step, doubt.meanwhile());
    }

    void running(long number) {
        if (progress.isOf(number) && progress.step() == null && progress.effect() != null) {
            progress.run();
        }
    }

    void effectRun(long number, String failure, long atNanos) {
        ledger.isAt(atNanos);
        if (progress.isOf(number) && progress.isRunning()) {
            progress.ran(failure);
            proceed();
        }
    }

    /** The plan is complete: the evolved system enters its next state. */
    private void arrive() {
        Decision decision = Objects.requireNonNull(progress.decision());
        Occurrence occurrence = progress.pending().occurrence();
        State from = progress.pending().from();
        // Who refuses a fact does not say where the device was before.
        Configuration before = decision instanceof Decision.Refused && from != null
                ? decision.before().withOriginal(from)
                : decision.before();
        String failures = progress.failures();
        long visit = ledger.stay.number();
        ledger.place.moveEvolved(decision.after(), ledger.out);
        ledger.followOwed |= isLateReaction(decision) && !ledger.rules.table().isFollowed(ledger.place.at());
        progress.end();
        if (decision.leavesState()) {
            Transition transition = decision.transition();
            ledger.enter(transition, transition == null ? Set.of() : transition.keeps());
        }
        ledger.ended(occurrence, before, outcome(decision, failures), decision, failures);
        if (decision instanceof Decision.Impossible && decision.transition() != null) {
            // Its timers restart: what is impossible now may be possible next time.
            ledger.stay.leave(ledger.out);
        }
        boolean again = ledger.enterAgain(occurrence);
        ledger.out.settle(ledger.place.at());
        ledger.start(visit, again);
    }

    /** Whether this is the new model's reaction to a fact, decided after a step had taken the device elsewhere. */
    private boolean isLateReaction(Decision decision) {
        Pending pending = progress.pending();
        return pending.from() != null
                && !(decision instanceof Decision.Refused)
                && pending.stepsBefore() < ledger.place.steps() - progress.stepsSent();
    }

    private static Outcome outcome(Decision decision, String failures) {
        if (decision instanceof Decision.NotAcceptable || decision instanceof Decision.Refused) {
            return Outcome.IGNORED;
        }
        return decision instanceof Decision.Impossible || !failures.isEmpty() ? Outcome.FAILED : Outcome.HANDLED;
    }

    private void giveWay(Pending pending, String overtaken) {
        if (pending.broken() == null) {
            again(pending, overtaken);
        } else {
            conclude(pending.number(), Outcome.OVERTAKEN, pending.afterBroken(overtaken));
        }
    }

    /** The plan has been overtaken: the occurrence is decided again, before all others. */
    private void again(String why) {
        again(progress.pending().again(), why);
    }

    private void again(Pending next, String why) {
        if (next.attempts() > MOST_ATTEMPTS || (!ledger.open && !next.hasHappened())) {
            conclude(next.number(), Outcome.FAILED, next.afterBroken("overtaken: " + why));
        } else {
            retry(next, why);
        }
    }

    /** The occurrence in progress has its turn again before all others but a question to the device, as {@code next}. */
    private void retry(Pending next, String why) {
        progress.end();
        ledger.mailbox.putBack(next);
        ledger.out.overtaken(next.occurrence(), why);
    }

    void failed(long number, String reason, long atNanos) {
        ledger.isAt(atNanos);
        if (!progress.isOf(number)) {
            return;
        }
        Pending pending = progress.pending();
        Step step = stepOnItsWay(number);
        List<Occurrence> meanwhile = progress.meanwhile();
        BrokenPlan broken = Recovery.from(ledger, reason);
        if (broken != null) {
            retry(pending.after(broken), reason);
        } else {
            breakOff(number, pending.afterBroken(reason));
        }
        if (step != null) {
            contradictIfImpossible(step.source(), null, meanwhile, false);
        }
    }

    void dismissed(long number, long atNanos) {
        ledger.isAt(atNanos);
        if (hasObeyed(number)) {
            breakOff(number, DISMISSED);
        } else {
            conclude(number, Outcome.IGNORED, DISMISSED);
        }
    }

    /** Whether nothing is left of the plan but effects. */
    private boolean hasObeyed(long number) {
        return progress.isOf(number) && progress.step() == null && progress.effect() != null;
    }

    /**
     * The occurrence in progress fails. What needs no component is done all the same: if the device has obeyed, the
     * transition is taken, without the effects that are left; after a fact that was not decided, the new model follows
     * the device.
     */
    private void breakOff(long number, String reason) {
        if (hasObeyed(number)) {
            if (progress.isRunning()) {
                progress.interruptEffect(reason);
            }
            progress.skipEffects(reason);
            arrive();
        } else if (progress.isOf(number) && progress.isUndecidedFact()) {
            State from = Objects.requireNonNull(progress.pending().from());
            State there = ledger.place.at().original();
            follow(ledger.rules.table().find(ledger.place.at().withOriginal(from), there), reason);
        } else {
            conclude(number, Outcome.FAILED, reason);
        }
    }

    /** @param failure what has failed before; empty if nothing has */
    private void follow(Decision found, String failure) {
        if (found.leavesState()) {
            ledger.stay.leave(ledger.out);
        }
        progress.decide(found);
        progress.fail(failure);
        arrive();
    }

    /** The occurrence in progress ends, whatever is left of its plan. */
    void conclude(long number, Outcome outcome, String reason) {
        if (progress.isOf(number)) {
            long visit = ledger.stay.number();
            ledger.start(visit, end(outcome, reason));
        }
    }

    /** Ends the occurrence in progress; returns whether the state is entered again. */
    private boolean end(Outcome outcome, String reason) {
        Pending pending = progress.pending();
        Decision decision = progress.decision();
        State from = pending.from();
        Configuration before = decision != null
                ? decision.before()
                : from == null ? ledger.place.at() : ledger.place.at().withOriginal(from);
        progress.end();
        ledger.ended(pending.occurrence(), before, outcome, null, reason);
        return ledger.enterAgain(pending.occurrence());
    }

    void givenUp(long number, String reason, long atNanos) {
        ledger.isAt(atNanos);
        giveUp(number, reason);
    }

    private void giveUp(long number, String reason) {
        if (!progress.isOf(number)) {
            return;
        }
        Step step = stepOnItsWay(number);
        List<Occurrence> meanwhile = progress.meanwhile();
        Decision decision = progress.decision();
        if (step == null) {
            breakOff(number, progress.pending().afterBroken(reason));
            return;
        }
        long visit = ledger.stay.number();
        boolean again = end(Outcome.FAILED, progress.pending().afterBroken(reason));
        String why = "it is unknown whether " + step.trigger() + " had its effect: " + reason;
        ledger.doubt(why, number, step, meanwhile, decision instanceof Decision.NewState ? decision : null);
        ledger.start(visit, again);
    }

    /** The thread that carried out the plan is gone. What was begun and not reported as finished is not begun again. */
    void interrupt() {
        if (progress.isSending()) {
            giveUp(progress.pending().number(), PROCESS_ENDED);
        } else if (!progress.isIdle() && progress.decision() == null) {
            // It was not yet decided: it has its turn again.
            Pending pending = progress.pending();
            progress.end();
            ledger.mailbox.putBack(pending);
        } else if (!progress.isIdle()) {
            if (progress.isRunning()) {
                progress.interruptEffect(PROCESS_ENDED);
            }
            progress.interrupt();
        }
    }

    /**
     * Ends an interrupted plan, since the converter closes. If the device has already acted or obeyed, the plan stays,
     * and is resumed when the converter is opened again.
     */
    void dropInterrupted() {
        if (progress.isInterrupted() && !progress.pending().hasHappened() && progress.step() != null) {
            conclude(progress.pending().number(), Outcome.FAILED, PROCESS_ENDED);
        }
    }

    /** Whether an interrupted plan waits that had already left the current state. */
    boolean isLeaving() {
        Decision decision = progress.decision();
        return progress.isInterrupted() && decision != null && decision.leavesState();
    }

    void located(long number, @Nullable State state, long atNanos) {
        ledger.isAt(atNanos);
        if (!progress.isOf(number)) {
            return;
        }
        // What the device did since it was asked may be older or newer than its answer.
        boolean overtaken =
                ledger.place.doubt() != null && !progress.meanwhile().isEmpty();
        if (overtaken && progress.pending().attempts() < MOST_ATTEMPTS) {
            progress.askAgain();
            ledger.out.locate();
            return;
        }
        Doubt doubt = ledger.place.doubt();
        if (doubt == null) {
            conclude(number, Outcome.HANDLED, FOUND_MEANWHILE);
        } else if (overtaken || state == null || !ledger.isDevicesState(state)) {
            State taken = ledger.place.at().original();
            String why = "the device cannot tell where it is; it is taken to be in " + taken;
            conclude(number, Outcome.IGNORED, why);
        } else {
            ledger.happensMeanwhile(new Occurrence.Found(state, ledger.nowNanos));
            ledger.out.reported(state, ledger.place.at().original());
            ledger.settleDoubt();
            isIn(state, number, ledger.completed(doubt, state));
        }
    }

    /**
     * The device has said where it is: the plan that was interrupted ends there, or else both models follow.
     *
     * @param completed what ends there; null if nothing does
     */
    private void isIn(State state, long number, @Nullable Decision completed) {
        if (completed == null && state.equals(ledger.place.at().original())) {
            ledger.followIfApart();
            conclude(number, Outcome.HANDLED, "the device is in " + state);
            return;
        }
        Decision found = ledger.rules.table().find(ledger.place.at(), state);
        ledger.place.moveDevice(state, ledger.out);
        // Facts that wait are older than the answer, and may lead the new model elsewhere.
        ledger.followOwed |= ledger.mailbox.holdsFacts();
        if (completed != null) {
            decide(completed);
        } else {
            follow(found, "");
        }
    }
}
