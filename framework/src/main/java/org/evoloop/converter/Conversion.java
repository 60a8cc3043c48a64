package org.evoloop.converter;

import java.util.List;
import org.evoloop.evolution.Decision;
import org.evoloop.evolution.Occurrence;
import org.evoloop.evolution.Step;
import org.evoloop.function.Visit;
import org.evoloop.loop.Failure;
import org.evoloop.statemachine.Event;
import org.jspecify.annotations.Nullable;

/**
 * A plan on its way to the device: the steps of one decision and how many of them have been taken. The knowledge moves on
 * one step at a time, after the step's effect.
 *
 * <p>Threading: carried out by one execute component at a time; it may be given up from any thread, after which a
 * component that still works on it changes nothing any more.
 */
public final class Conversion {
    private final ConverterCore core;
    private final Occurrence occurrence;
    private final Decision decision;
    private int taken;
    private boolean begun;
    private boolean over;
    private String failedEffects = "";

    Conversion(ConverterCore core, Occurrence occurrence, Decision decision) {
        this.core = core;
        this.occurrence = occurrence;
        this.decision = decision;
    }

    /** The event that is converted. */
    public Occurrence occurrence() {
        return occurrence;
    }

    /** What it was found to mean. */
    public Decision decision() {
        return decision;
    }

    /** The event to send next; null if none is left. */
    synchronized @Nullable Event nextToSend() {
        // By index, here and on: an iterator or a stream would be garbage in every event.
        List<Step> steps = decision.steps();
        for (int index = taken; index < steps.size(); index++) {
            if (!steps.get(index).byDevice()) {
                return steps.get(index).trigger();
            }
        }
        return null;
    }

    synchronized boolean isOver() {
        return over;
    }

    /** Takes the steps that {@code execute} can send, and ends the conversion if none is left then. */
    void performWith(EventExecute execute) throws Exception {
        begin();
        for (Step step = nextStep(); step != null; step = nextStep()) {
            if (!step.byDevice() && !execute.events().contains(step.trigger())) {
                if (core.dispatchable(step.trigger())) {
                    return;
                }
                throw new IllegalStateException("no execute component can send " + step.trigger() + " any more");
            }
            core.transcribe(decision, step);
            if (!step.byDevice()) {
                execute.awaitReady(step);
                core.requireOpen(step);
                execute.send(step);
            }
            took(step);
        }
        runEffects(execute);
        Visit entered = end();
        try {
            execute.settled(core.knowledge.configuration());
        } finally {
            core.visits.startFunction(entered);
        }
    }

    /** In order; one that fails keeps none of the others from being run, since the device has obeyed. */
    private void runEffects(EventExecute execute) throws Exception {
        for (int index = 0; index < decision.effects().size(); index++) {
            String effect = decision.effects().get(index);
            synchronized (this) {
                requireOngoing();
            }
            try {
                core.knowledge.bindings().run(effect);
            } catch (InterruptedException stop) {
                throw stop;
            } catch (Exception cause) {
                Failure<Occurrence> failure = new Failure<>(execute.name(), "effect " + effect, 0, occurrence, cause);
                core.effectFailed(failure);
                failedEffects += (failedEffects.isEmpty() ? "" : "; ") + failure;
            }
        }
    }

    /** What went wrong with the effects; empty if nothing did. */
    String failedEffects() {
        return failedEffects;
    }

    private synchronized @Nullable Step nextStep() throws InterruptedException {
        requireOngoing();
        return taken < decision.steps().size() ? decision.steps().get(taken) : null;
    }

    private synchronized void begin() throws InterruptedException {
        requireOngoing();
        if (!begun) {
            begun = true;
            core.begins(this);
        }
    }

    private synchronized void took(Step step) throws InterruptedException {
        requireOngoing();
        taken++;
        core.took(step);
    }

    private synchronized @Nullable Visit end() throws InterruptedException {
        requireOngoing();
        over = true;
        return core.arrives(this);
    }

    private void requireOngoing() throws InterruptedException {
        if (over) {
            throw new InterruptedException("given up");
        }
    }

    /** Gives the conversion up; false if it has come to its end before. */
    synchronized boolean giveUp() {
        boolean ongoing = !over;
        over = true;
        return ongoing;
    }

    /** Whether the state in which the event occurred has been left, even if nothing came of it. */
    synchronized boolean hasLeftState() {
        return begun && decision.leavesState();
    }
}
