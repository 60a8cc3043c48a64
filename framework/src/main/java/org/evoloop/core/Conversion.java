package org.evoloop.core;

import java.util.Objects;
import java.util.Set;
import org.evoloop.evolution.Configuration;
import org.evoloop.evolution.Decision;
import org.evoloop.evolution.Occurrence;
import org.evoloop.evolution.Step;
import org.evoloop.statemachine.State;
import org.evoloop.statemachine.Transition;

/** How the occurrence in progress is carried out, step by step, and how it ends. */
final class Conversion {
    static final String FOUND_MEANWHILE = "the device was found meanwhile";

    /** So often may the device overtake the plans for one occurrence. */
    static final int MOST_ATTEMPTS = 8;

    private final Ledger ledger;

    Conversion(Ledger ledger) {
        this.ledger = ledger;
    }

    /** Takes up a plan. */
    void plan(Input.Planned planned) {
        Work current = ledger.inProgress(planned.number());
        if (current == null || current.decision() != null) {
            return;
        }
        Decision decision = planned.decision();
        if (!decision.start().equals(ledger.place.at())) {
            again(current, "it was decided at " + decision.start(), planned.atNanos());
            return;
        }
        Pending pending = current.pending();
        ledger.out.add(new Output.Decided(
                pending, decision, planned.atNanos() - pending.occurrence().observedNanos()));
        if (decision.leavesState()) {
            // Before the first step leaves: a function that still moved the device would contradict it.
            ledger.stay.leave(ledger.out);
        }
        ledger.work = current.decided(decision);
        goOn(ledger.work, planned.atNanos());
    }

    private void goOn(Work current, long atNanos) {
        long number = current.pending().number();
        Step step = current.nextStep();
        String effect = current.nextEffect();
        if (current.decision() instanceof Decision.Inquiry) {
            ledger.out.add(new Output.Locate(number));
        } else if (step != null) {
            ledger.out.add(new Output.Send(number, step));
        } else if (effect != null) {
            ledger.out.add(new Output.Run(number, effect));
        } else {
            arrive(current, atNanos);
        }
    }

    /** The next step is about to be sent. */
    void send(Input.Sending sending) {
        Work current = ledger.inProgress(sending.number());
        Step step = current == null || current.sending() ? null : current.nextStep();
        if (current != null && step != null) {
            if (step.source().equals(ledger.place.at().original())) {
                ledger.work = current.sendingNext();
            } else {
                again(current, "the device left " + step.source() + " by itself", sending.atNanos());
            }
        }
    }

    /** The step has had its effect. */
    void took(Input.Sent sent) {
        Work current = ledger.inProgress(sent.number());
        Step step = current == null ? null : current.stepOnItsWay();
        if (current == null || step == null) {
            tookLate(sent);
            return;
        }
        State target = step.target();
        boolean sure = true;
        if (!current.meanwhile().isEmpty()) {
            // In the order in which they were told, the step came last.
            target = Overlap.takes(ledger.rules.table(), ledger.place.at().original(), step);
            sure = sent.inOrder() || Overlap.alwaysEndsIn(target, ledger.rules.table(), step, current.meanwhile());
        }
        ledger.place.took(target, sent.atNanos(), ledger.out);
        ledger.out.add(new Output.Took(step));
        Work next = current.tookNext();
        ledger.work = next;
        if (!sure || !target.equals(step.target())) {
            again(next, "the device acted by itself while " + step.trigger() + " was sent", sent.atNanos());
        } else {
            goOn(next, sent.atNanos());
        }
        if (!sure) {
            ledger.doubt(
                    "nobody knows whether the device acted before or after it took " + step.trigger(),
                    current,
                    step,
                    sent.atNanos());
        }
    }

    /** A step that was given up has had its effect after all, which settles its doubt if the order is known. */
    private void tookLate(Input.Sent sent) {
        Doubt doubt = ledger.place.lastDoubt();
        if (doubt == null) {
            return;
        }
        State target = Overlap.takes(ledger.rules.table(), ledger.place.at().original(), doubt.step());
        Work current = ledger.work;
        boolean another = current != null && current.sending();
        if (doubt.number() == sent.number() && isOrderKnown(sent, doubt, target, another)) {
            ledger.settleDoubt();
            ledger.place.doubt(doubt.stepsBefore() == Doubt.UNSETTLED ? ledger.place.lastDoubt() : null);
            ledger.place.took(target, sent.atNanos(), ledger.out);
            ledger.out.add(new Output.Took(doubt.step()));
            if (current != null && another) {
                // To the step that is being sent, that is something which the device did before.
                ledger.work = current.acted(new Occurrence.Found(target, sent.atNanos()));
            }
        } else if (doubt.settled()) {
            ledger.place.doubt(doubt.settled(false));
            ledger.out.add(new Output.Doubted(doubt.why()));
            ledger.ask(sent.atNanos());
        }
    }

    private boolean isOrderKnown(Input.Sent sent, Doubt doubt, State target, boolean another) {
        if (sent.inOrder()) {
            return doubt.settled() || doubt.stepsBefore() == ledger.place.steps();
        }
        return doubt.stepsBefore() == ledger.place.steps()
                && !another
                && Overlap.alwaysEndsIn(target, ledger.rules.table(), doubt.step(), doubt.meanwhile());
    }

    /** An effect was run. */
    void ran(Input.EffectRun run) {
        Work current = ledger.inProgress(run.number());
        if (current != null) {
            Work next = current.ranNext(run.failure());
            ledger.work = next;
            goOn(next, run.atNanos());
        }
    }

    /** All is done: the evolved system enters its next state. */
    private void arrive(Work current, long atNanos) {
        Decision decision = Objects.requireNonNull(current.decision());
        long visit = ledger.stay.number();
        ledger.place.move(ledger.place.at().withEvolved(decision.after().evolved()), ledger.out);
        if (decision.leavesState()) {
            Transition transition = decision.transition();
            ledger.enter(transition, transition == null ? Set.of() : transition.keeps(), atNanos);
        }
        ledger.work = null;
        ledger.ended(
                current.pending().occurrence(),
                decision.before(),
                outcome(current, decision),
                decision,
                current.failedEffects());
        if (decision instanceof Decision.Impossible && decision.transition() != null) {
            // Its timers start anew: what was impossible now may be possible the next time.
            ledger.stay.leave(ledger.out);
        }
        ledger.enterAgain(atNanos);
        ledger.out.add(new Output.Settle(ledger.place.at()));
        ledger.start(visit);
    }

    private static Outcome outcome(Work done, Decision decision) {
        if (decision instanceof Decision.NotAcceptable || decision instanceof Decision.Refused) {
            return Outcome.IGNORED;
        }
        return decision instanceof Decision.Impossible || !done.failedEffects().isEmpty()
                ? Outcome.FAILED
                : Outcome.HANDLED;
    }

    /** The plan has been overtaken: the occurrence is decided anew, before all others. */
    private void again(Work current, String why, long atNanos) {
        Pending next = current.pending().again();
        Occurrence occurrence = next.occurrence();
        if (next.attempts() > MOST_ATTEMPTS || (!ledger.open && !next.hasHappened())) {
            conclude(next.number(), Outcome.FAILED, "overtaken: " + why, atNanos);
        } else {
            ledger.work = null;
            ledger.line.addFirst(next);
            ledger.out.add(new Output.Overtaken(occurrence, why));
        }
    }

    /** The occurrence in progress ends before its plan was carried out. */
    void conclude(long number, Outcome outcome, String reason, long atNanos) {
        Work current = ledger.inProgress(number);
        if (current == null) {
            return;
        }
        Pending pending = current.pending();
        Decision decision = current.decision();
        State from = pending.from();
        Configuration before = decision != null
                ? decision.before()
                : from == null ? ledger.place.at() : ledger.place.at().withOriginal(from);
        long visit = ledger.stay.number();
        ledger.work = null;
        ledger.ended(pending.occurrence(), before, outcome, null, reason);
        ledger.enterAgain(atNanos);
        ledger.start(visit);
    }

    /** A component was given up, maybe with a step on its way. */
    void giveUp(Input.GivenUp givenUp) {
        Work current = ledger.inProgress(givenUp.number());
        Step step = current == null ? null : current.stepOnItsWay();
        conclude(givenUp.number(), Outcome.FAILED, givenUp.reason(), givenUp.atNanos());
        if (current != null && step != null) {
            ledger.doubt(
                    "nobody knows whether " + step.trigger() + " had its effect: " + givenUp.reason(),
                    current,
                    step,
                    givenUp.atNanos());
        }
    }

    /** The device was asked. */
    void located(Input.Located located) {
        Work current = ledger.inProgress(located.number());
        if (current == null) {
            return;
        }
        // What the device has done since it was asked may be older or newer than its answer.
        boolean overtaken = ledger.place.doubt() != null && !current.meanwhile().isEmpty();
        if (overtaken && current.pending().attempts() < MOST_ATTEMPTS) {
            ledger.work = current.askingAgain();
            ledger.out.add(new Output.Locate(located.number()));
            return;
        }
        State state = located.state();
        if (ledger.place.doubt() == null) {
            conclude(located.number(), Outcome.HANDLED, FOUND_MEANWHILE, located.atNanos());
        } else if (overtaken || state == null || !ledger.isDevicesState(state)) {
            conclude(
                    located.number(),
                    Outcome.IGNORED,
                    "the device cannot tell where it is; it is taken to be in "
                            + ledger.place.at().original(),
                    located.atNanos());
        } else {
            ledger.happensMeanwhile(new Occurrence.Found(state, located.atNanos()));
            ledger.settleDoubt();
            isIn(state, current, located.atNanos());
        }
    }

    /** The device has told where it is; both models follow if that is news. */
    private void isIn(State state, Work current, long atNanos) {
        if (state.equals(ledger.place.at().original())) {
            conclude(current.pending().number(), Outcome.HANDLED, "the device is in " + state, atNanos);
        } else {
            Decision found = ledger.rules.table().find(ledger.place.at(), state);
            ledger.place.moveDevice(state, ledger.out);
            if (found.leavesState()) {
                ledger.stay.leave(ledger.out);
            }
            arrive(current.decided(found), atNanos);
        }
    }
}
