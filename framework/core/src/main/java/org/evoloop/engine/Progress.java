package org.evoloop.engine;

import java.util.List;
import java.util.Objects;
import java.util.function.UnaryOperator;
import org.evoloop.evolution.Decision;
import org.evoloop.evolution.Occurrence;
import org.evoloop.evolution.Step;
import org.jspecify.annotations.Nullable;

/**
 * The progress of the occurrence in progress. One object is used for all: a new one would be garbage in every event.
 */
final class Progress {
    private @Nullable Pending pending;
    private @Nullable Decision decision;
    private int taken;
    private int effectsRun;
    private String failures = "";
    private Work.Stage stage = Work.Stage.READY;
    private List<Occurrence> meanwhile = List.of();

    Progress(@Nullable Work work) {
        restore(work);
    }

    void restore(@Nullable Work work) {
        end();
        if (work != null) {
            pending = work.pending();
            decision = work.decision();
            taken = work.taken();
            effectsRun = work.effectsRun();
            failures = work.failedEffects();
            stage = work.stage();
            meanwhile = work.meanwhile();
        }
    }

    /** A copy as a value; null if nothing is in progress. */
    @Nullable
    Work work() {
        return pending == null ? null : new Work(pending, decision, taken, effectsRun, failures, stage, meanwhile);
    }

    /** Whether nothing is in progress. */
    boolean isIdle() {
        return pending == null;
    }

    /** Whether the occurrence of this number is in progress and was not given up. */
    boolean isOf(long number) {
        return pending != null && pending.number() == number;
    }

    /** The occurrence in progress; there must be one. */
    Pending pending() {
        return Objects.requireNonNull(pending);
    }

    /** Its decision; null while it is being analyzed and planned. */
    @Nullable
    Decision decision() {
        return decision;
    }

    /** What has failed, though the plan continues; empty if nothing has. */
    String failures() {
        return failures;
    }

    /** Whether it is a fact that the record has followed, and about which nothing is decided yet. */
    boolean isUndecidedFact() {
        return decision == null && pending != null && pending.from() != null;
    }

    /** What the device did by itself while the step was being sent, or while it was asked for its state. */
    List<Occurrence> meanwhile() {
        return meanwhile;
    }

    boolean isSending() {
        return stage == Work.Stage.SENDING;
    }

    boolean isRunning() {
        return stage == Work.Stage.RUNNING;
    }

    /** Whether a plan waits until the converter is opened. */
    boolean isInterrupted() {
        return stage == Work.Stage.INTERRUPTED;
    }

    /** Whether a plan has its turn again. */
    boolean isResumed() {
        return stage == Work.Stage.RESUMED;
    }

    /** Whether the device's own actions may now come before or after the step or inquiry in progress. */
    boolean mayOverlap() {
        return isSending() || decision instanceof Decision.Inquiry;
    }

    /** How many of the decision's steps have been sent and have had their effect. */
    int stepsSent() {
        return Work.stepsSent(decision, taken);
    }

    /** The step to be sent next, or being sent; null if there is none left. */
    @Nullable
    Step step() {
        return decision != null && taken < decision.steps().size()
                ? decision.steps().get(taken)
                : null;
    }

    /** The effect to be run next; null if there is none left. */
    @Nullable
    String effect() {
        return decision != null && effectsRun < decision.effects().size()
                ? decision.effects().get(effectsRun)
                : null;
    }

    void begin(Pending next) {
        end();
        pending = next;
    }

    /** Nothing is in progress any more. */
    void end() {
        pending = null;
        decision = null;
        taken = 0;
        effectsRun = 0;
        failures = "";
        becomes(Work.Stage.READY);
    }

    void decide(Decision what) {
        begin(pending());
        decision = what;
        taken = what.deviceBegan() ? 1 : 0;
    }

    private void becomes(Work.Stage next) {
        stage = next;
        meanwhile = List.of();
    }

    void send() {
        becomes(Work.Stage.SENDING);
    }

    void run() {
        becomes(Work.Stage.RUNNING);
    }

    void interrupt() {
        becomes(Work.Stage.INTERRUPTED);
    }

    void resume() {
        becomes(Work.Stage.RESUMED);
    }

    void proceed() {
        becomes(Work.Stage.READY);
    }

    void took() {
        taken++;
        becomes(Work.Stage.READY);
    }

    void ran(String failure) {
        effectsRun++;
        stage = Work.Stage.READY;
        fail(failure);
    }

    /** Notes what has failed, if not empty. */
    void fail(String failure) {
        failures += failures.isEmpty() || failure.isEmpty() ? failure : "; " + failure;
    }

    /** The effect being run does not report its end. */
    void interruptEffect(String reason) {
        ran("it is unknown whether the effect " + effect() + " was run: " + reason);
    }

    /** The effects that were not begun are not run any more. */
    void skipEffects(String reason) {
        for (String next = effect(); next != null; next = effect()) {
            ran("the effect " + next + " was not run: " + reason);
        }
    }

    /** Replaces the occurrence in progress. */
    void replace(UnaryOperator<Pending> another) {
        if (pending != null) {
            pending = another.apply(pending);
        }
    }

    /** Notes what the device did by itself while a step was being sent, or while it was asked. */
    void acted(Occurrence fact) {
        meanwhile = Overlap.add(meanwhile, fact);
    }

    /** The device is asked once more. */
    void askAgain() {
        pending = pending().again();
        meanwhile = List.of();
    }
}
