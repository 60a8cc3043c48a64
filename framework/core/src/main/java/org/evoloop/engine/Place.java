package org.evoloop.engine;

import org.evoloop.evolution.Configuration;
import org.evoloop.evolution.Occurrence;
import org.evoloop.statemachine.State;
import org.jspecify.annotations.Nullable;

/**
 * The record of the states of device and evolved system, and whether it is in doubt.
 *
 * <p>A fact moves it when it is observed, and a step when it has had its effect, in the order in which they are
 * reported.
 */
final class Place {
    private Configuration at;
    private long steps;
    private long lastStepNanos;
    private @Nullable Doubt doubt;

    Place(Snapshot snapshot) {
        at = snapshot.at();
        restore(snapshot);
    }

    void restore(Snapshot snapshot) {
        at = snapshot.at();
        steps = snapshot.steps();
        lastStepNanos = snapshot.lastStepNanos();
        doubt = snapshot.doubt();
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

    /** Why the record may be wrong; null if it is certain. */
    @Nullable
    Doubt doubt() {
        return doubt == null || doubt.settled() ? null : doubt;
    }

    /** The present doubt, or a settled one whose step may still be reported to have had its effect. */
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

    /** Whether a finding agrees with the record. */
    boolean isNoNews(Occurrence.Found found) {
        return found.state().equals(at.original());
    }

    /** Whether a finding may be older than the last step. */
    boolean isOld(Occurrence.Found found) {
        return steps > 0 && found.observedNanos() < lastStepNanos;
    }

    /** Moves the evolved system to its state in {@code end}; the device stays where it is. */
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
