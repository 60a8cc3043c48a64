package org.evoloop.converter.running;

import org.evoloop.converter.UnknownEffectException;
import org.evoloop.converter.attachment.ExecuteAccess;
import org.evoloop.converter.attachment.UserCode;
import org.evoloop.converter.recording.Records;
import org.evoloop.engine.Input;
import org.evoloop.engine.Inputs;
import org.evoloop.engine.Output;
import org.evoloop.engine.Pending;
import org.evoloop.evolution.Decision;
import org.evoloop.evolution.Occurrence;
import org.evoloop.evolution.Step;
import org.evoloop.evolution.Values;
import org.evoloop.flight.WorkEvent;
import org.evoloop.loop.Failure;
import org.evoloop.statemachine.State;
import org.evoloop.time.Clock;
import org.jspecify.annotations.Nullable;

/**
 * Carries out the core's directives: on the threads of the execute components, one at a time; those that belong to no
 * occurrence on the thread that opens, closes or gives up.
 */
final class PlanExecutor implements ExecuteAccess.Host {
    private final CoreDriver driver;
    private final Inputs inputs;
    private final CoreOutputs outputs;
    private final Clock clock;
    private final Senders senders;
    private final Visits visits;
    private final CurrentKnowledge knowledge;
    private final Records records;
    private final Reports reports;
    private Runnable look = () -> {};
    private volatile String runningEffect = "";

    /** Is told of failures of components that do not end the event, since others continue. */
    interface Reports {
        void failed(ExecuteAccess execute, String phase, Throwable cause);
    }

    PlanExecutor(
            CoreDriver driver,
            Senders senders,
            Visits visits,
            CurrentKnowledge knowledge,
            Records records,
            Reports reports) {
        this.driver = driver;
        this.inputs = driver.inputs;
        this.outputs = driver.outputs;
        this.clock = driver.clock;
        this.senders = senders;
        this.reports = reports;
        this.visits = visits;
        this.knowledge = knowledge;
        this.records = records;
    }

    /** Sets how the loop finds that there is something to do; before the first event. */
    void attach(Runnable looks) {
        look = looks;
    }

    @Override
    public void carryOut(Occurrence occurrence, Decision plan, ExecuteAccess execute) throws Exception {
        // This thread keeps its agenda. When it is given up, that agenda is ended and the others get a new one, so that
        // it
        // finds nothing to do whenever it returns.
        Agenda agenda = takeUp(occurrence, plan);
        long number = agenda.turn();
        Throwable notSettled = null;
        for (Output.Directive next = agenda.poll(); next != null; next = agenda.poll()) {
            if (next instanceof Output.Send send) {
                if (!senders.canSend(send.step(), execute)) {
                    senders.handBack(occurrence, agenda);
                    return;
                }
                send(number, send.step(), occurrence.values(), execute);
            } else if (next instanceof Output.Run run) {
                run(number, run.effect(), occurrence, execute);
            } else if (next instanceof Output.Locate) {
                if (!locate(number, execute)) {
                    senders.handBack(occurrence, agenda);
                    return;
                }
            } else if (next instanceof Output.Settle settle) {
                records.transcript().say();
                ExecuteAccess first = agenda.settles(execute);
                notSettled = settle(execute, settle);
                if (senders.settlesAfter(execute, first) != null) {
                    if (notSettled != null) {
                        reports.failed(execute, "settled", notSettled);
                    }
                    senders.handBack(occurrence, agenda);
                    return;
                }
            } else {
                visit(next, occurrence);
            }
        }
        records.transcript().say();
        if (notSettled instanceof Error error) {
            throw error;
        } else if (notSettled instanceof Exception exception) {
            throw exception;
        }
    }

    /**
     * Begins a plan, unless it has begun.
     *
     * @return the directives of the plan
     * @throws IllegalStateException if it is a plan for another occurrence than that in progress, or has states or
     *     transitions that the models do not have
     */
    private Agenda takeUp(Occurrence occurrence, Decision plan) {
        synchronized (driver) {
            Pending pending = outputs.begun;
            if (pending == null || pending.occurrence() != occurrence) {
                throw new IllegalStateException("the plan is for " + occurrence + ", which is not in the loop");
            }
            Agenda agenda = outputs.agenda;
            if (agenda.turn() != pending.number()) {
                Decision decided = driver.decided();
                if (plan != decided && !plan.equals(decided)) {
                    PlanCheck.requireDrawnIn(driver.rules().table().models(), plan);
                }
                agenda.begin(pending.number());
                inputs.planned(pending.number(), plan, clock.nanoTime());
            }
            return agenda;
        }
    }

    private void send(long number, Step step, Values values, ExecuteAccess execute) throws Exception {
        WorkEvent work = WorkEvent.begun();
        try {
            sendWhenReady(number, step, values, execute);
        } finally {
            WorkEvent.ended(work, records.flight().converter(), WorkEvent.Kind.SEND, step);
        }
    }

    private void sendWhenReady(long number, Step step, Values values, ExecuteAccess execute) throws Exception {
        execute.carry(values);
        execute.awaitReady(step);
        if (!driver.rules().table().isOpen(step, knowledge.bindings().with(values))) {
            throw new IllegalStateException("the guards of the original model do not let " + step + " be taken now");
        }
        // Announced before it is sent: after a crash between the two the step is in doubt, and not forgotten.
        if (announce(number, execute)) {
            try {
                execute.send(step);
            } catch (UnknownEffectException unknown) {
                throw unknown;
            } catch (Exception | Error failed) {
                forget(number, execute);
                throw failed;
            }
            execute.sendReturned();
        }
    }

    /**
     * The step had no effect, so a report of one must not be taken for that of another component's step. If it was
     * given up, it may still have one.
     */
    private void forget(long number, ExecuteAccess execute) {
        synchronized (driver) {
            if (driver.core.maySend(number)) {
                execute.setSending(0);
            }
        }
    }

    /** Announces a step; false if it must not be sent, since the device has left the step's source. */
    private boolean announce(long number, ExecuteAccess execute) {
        synchronized (driver) {
            inputs.sending(number);
            // Asked in the same hold of the lock: a report that the device has moved comes before or after, not in
            // between.
            boolean may = driver.core.maySend(number);
            if (may) {
                execute.setSending(number);
            }
            return may;
        }
    }

    /**
     * A second call for a step waits for the first, since the plan cannot continue before its consequences are known.
     *
     * @param inOrder see {@link Input.Sent}
     */
    @Override
    public void tookEffect(ExecuteAccess execute, boolean inOrder) {
        // Out of order, the component that sent it is about to return, and the loop looks then.
        if (isLate(execute, inOrder) && inOrder) {
            look.run();
        }
    }

    /** Whether the step with this effect was given up before, and something is to be done about that. */
    private boolean isLate(ExecuteAccess execute, boolean inOrder) {
        synchronized (driver) {
            long number = execute.sending();
            execute.setSending(0);
            if (number == 0) {
                return false;
            }
            // Asked before the core hears of it: afterwards the step may not be sent in any case.
            boolean late = !driver.core.maySend(number);
            inputs.sent(number, inOrder, clock.nanoTime());
            return late && driver.core.hasNext();
        }
    }

    private void run(long number, String effect, Occurrence occurrence, ExecuteAccess execute)
            throws InterruptedException {
        synchronized (driver) {
            inputs.running(number);
        }
        String failure = run(effect, occurrence, execute);
        synchronized (driver) {
            inputs.effectRun(number, failure, clock.nanoTime());
        }
    }

    /** Returns what went wrong. The device has already obeyed, so the other effects are still run. */
    private String run(String effect, Occurrence occurrence, ExecuteAccess execute) throws InterruptedException {
        // For status, which reads it while the effect hangs.
        runningEffect = effect;
        WorkEvent work = WorkEvent.begun();
        try {
            Throwable cause = UserCode.call(() -> knowledge.bindings().run(effect, occurrence.values()));
            if (cause == null) {
                return "";
            }
            Failure<Occurrence> failure = new Failure<>(execute.name(), "effect " + effect, 0, occurrence, cause);
            records.failures().fault("effect " + effect, failure);
            return failure.toString();
        } finally {
            WorkEvent.ended(work, records.flight().converter(), WorkEvent.Kind.EFFECT, effect);
            runningEffect = "";
        }
    }

    /** Asks {@code execute}; false if it does not know and another component is left to be asked. */
    private boolean locate(long number, ExecuteAccess execute) throws Exception {
        boolean last = senders.isLast(execute);
        State state = execute.locate(
                        knowledge.access()::located, last, cause -> reports.failed(execute, "locate", cause))
                .orElse(null);
        if (state == null && !last) {
            return false;
        }
        synchronized (driver) {
            inputs.located(number, state, clock.nanoTime());
        }
        return true;
    }

    /** Returns what {@code execute} threw; null if it has settled. */
    private static @Nullable Throwable settle(ExecuteAccess execute, Output.Settle settle) {
        // Not by UserCode: this is done for every event, and would make an object each time.
        try {
            execute.settled(settle.now());
            return null;
        } catch (Exception | LinkageError | AssertionError | StackOverflowError cause) {
            return cause;
        }
    }

    /** The effect that is being run; empty if none is. */
    String runningEffect() {
        return runningEffect;
    }

    /** Carries out directives that belong to no occurrence, such as the beginning and end of visits. */
    void carryOut() {
        carryOut(null);
    }

    /** There is no plan for {@code occurrence}: ends it, and carries out what follows. */
    void dismiss(Occurrence occurrence) {
        synchronized (driver) {
            Pending pending = outputs.begun;
            if (pending != null && pending.occurrence() == occurrence && driver.core.isBusy()) {
                inputs.dismissed(pending.number(), clock.nanoTime());
            }
        }
        carryOut(occurrence);
    }

    /**
     * The occurrence in progress has failed: carries out what follows.
     *
     * @param unknown whether it is uncertain if the step being sent had its effect
     */
    void breakOff(Occurrence occurrence, String reason, boolean unknown) {
        synchronized (driver) {
            Pending pending = outputs.begun;
            // The component that was given up may return at any time, and must find nothing to do.
            outputs.agenda = outputs.agenda.end();
            if (pending != null && driver.core.isBusy()) {
                outputs.agenda = new Agenda();
                long now = clock.nanoTime();
                if (unknown) {
                    inputs.givenUp(pending.number(), reason, now);
                } else {
                    inputs.failed(pending.number(), reason, now);
                }
            }
        }
        carryOut(occurrence);
    }

    /** The thread that carries out directives that belong to no occurrence hangs, and is left to itself. */
    void abandon() {
        synchronized (driver) {
            outputs.agenda = outputs.agenda.end();
        }
    }

    private void carryOut(@Nullable Occurrence after) {
        Agenda agenda;
        synchronized (driver) {
            agenda = outputs.agenda;
        }
        for (Output.Directive next = agenda.poll(); next != null; next = agenda.poll()) {
            visit(next, after);
        }
        records.transcript().say();
    }

    /** The values of the event with which a state is entered; null if it is entered again. */
    private @Nullable Values carried(Occurrence after) {
        synchronized (driver) {
            return outputs.left ? after.values() : null;
        }
    }

    /** @param after the occurrence that has ended; null if it is not about one */
    private void visit(Output.Directive directive, @Nullable Occurrence after) {
        if (directive instanceof Output.Leave) {
            visits.leave();
        } else if (directive instanceof Output.Enter enter) {
            visits.enter(enter, after == null ? null : carried(after), after == null);
        } else if (directive instanceof Output.CarryOver over) {
            visits.carryOver(over);
        } else if (directive instanceof Output.Start start) {
            visits.start(start);
        }
    }
}
