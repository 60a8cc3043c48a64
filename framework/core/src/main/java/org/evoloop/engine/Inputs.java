package org.evoloop.engine;

import org.evoloop.evolution.Decision;
import org.evoloop.evolution.Occurrence;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.State;
import org.jspecify.annotations.Nullable;

/**
 * Receives inputs: a {@link Core}, or a recorder that passes them on to one. Every {@link Input} can be given as a
 * value, with {@link #apply}, or by the method of the same name, which allocates nothing.
 *
 * @since 0.1
 */
public interface Inputs {

    /** Takes {@code input}; its record describes the meaning. */
    default void apply(Input input) {
        input.applyTo(this);
    }

    /** See {@link Input.Opened}. */
    void opened(long atNanos);

    /** See {@link Input.Closing}. */
    void closing();

    /** See {@link Input.Closed}. */
    void closed();

    /** See {@link Input.Recovered}. */
    void recovered(long atNanos);

    /** See {@link Input.Observed}. */
    void observed(Occurrence occurrence);

    /** See {@link Input.TimerDue}. */
    void timerDue(long visit, Event event, long atNanos);

    /** See {@link Input.Ready}. */
    void ready();

    /** See {@link Input.Planned}. */
    void planned(long number, Decision decision, long atNanos);

    /** See {@link Input.Dismissed}. */
    void dismissed(long number, long atNanos);

    /** See {@link Input.Sending}. */
    void sending(long number);

    /** See {@link Input.Sent}. */
    void sent(long number, boolean inOrder, long atNanos);

    /** See {@link Input.Running}. */
    void running(long number);

    /** See {@link Input.EffectRun}. */
    void effectRun(long number, String failure, long atNanos);

    /** See {@link Input.Located}. */
    void located(long number, @Nullable State state, long atNanos);

    /** See {@link Input.Failed}. */
    void failed(long number, String reason, long atNanos);

    /** See {@link Input.GivenUp}. */
    void givenUp(long number, String reason, long atNanos);

    /** See {@link Input.Changed}. */
    void changed(Rules rules, long atNanos);

    /** See {@link Input.Evolved}. */
    void evolved(Swap swap, long atNanos);
}
