package org.evoloop.core;

import org.evoloop.evolution.Configuration;
import org.evoloop.evolution.Occurrence;
import org.evoloop.statemachine.State;
import org.jspecify.annotations.Nullable;

/**
 * The record of where the device and the evolved system are, and how sure it is.
 *
 * <p>A fact moves it when it is observed, and a step when it has had its effect, in the order in which they are reported.
 */
final class Place {
    private Configuration at;
    private long steps;
    private long lastStepNanos;
    private @Nullable Doubt doubt;

    Place(Configuration at, long steps, long lastStepNanos, @Nullable Doubt doubt) {
        this.at = at;
        this.steps = steps;
        this.lastStepNanos = lastStepNanos;
        this.doubt = doubt;
    }

    Configuration at() {
        return at;
    }

    /** How many steps have been sent and have had their effect. */
    long steps() {
        return steps;
    }

    long lastStepNanos() {
        return lastStepNanos;
    }

    /** Why the record may be wrong; null if it is sure. */
    @Nullable
    Doubt doubt() {
        return doubt == null || doubt.settled() ? null : doubt;
    }

    /** The same, or a doubt that was settled while its step may still be told to have had its effect. */
    @Nullable
    Doubt lastDoubt() {
        return doubt;
    }

    void doubt(@Nullable Doubt newDoubt) {
        doubt = newDoubt;
    }

    void move(Configuration next, Outputs out) {
        if (!next.equals(at)) {
            out.moved(at, next);
            at = next;
        }
    }

    void moveDevice(State state, Outputs out) {
        if (!state.equals(at.original())) {
            move(at.withOriginal(state), out);
        }
    }

    /** Whether a finding says nothing that the record does not know. */
    boolean isNoNews(Occurrence.Found found) {
        return found.state().equals(at.original());
    }

    /** Whether a finding may be older than the last step. */
    boolean isOld(Occurrence.Found found) {
        return steps > 0 && found.observedNanos() < lastStepNanos;
    }

    /** The evolved system goes where {@code end} says; the device is where it is. */
    void moveEvolved(Configuration end, Outputs out) {
        move(end.original().equals(at.original()) ? end : at.withEvolved(end.evolved()), out);
    }

    /** A step has had its effect, and took the device to {@code state}. */
    void took(State state, long atNanos, Outputs out) {
        steps++;
        lastStepNanos = atNanos;
        moveDevice(state, out);
    }
}
