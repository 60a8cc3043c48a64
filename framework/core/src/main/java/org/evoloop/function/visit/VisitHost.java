package org.evoloop.function.visit;

import java.util.function.Consumer;
import org.evoloop.evolution.EventOutcome;
import org.evoloop.evolution.Values;
import org.evoloop.function.Visit;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.State;
import org.evoloop.time.Clock;

/**
 * What a visit needs from its converter.
 *
 * <p>Threading: called from any thread.
 */
public interface VisitHost {

    /** The converter's time. */
    Clock clock();

    /** Where the device is, as far as is known: a state of the original model. */
    State device();

    /** Whether functions have threads of their own. */
    boolean threads();

    /** Whether the new model has a transition for the event in the visited state. */
    boolean accepts(Visit visit, Event event);

    /**
     * Refuses an event that neither model knows.
     *
     * @throws IllegalArgumentException if neither model knows the event; the message suggests the most similar names
     */
    void requireKnown(Event event);

    /**
     * Refuses an event that the visited state defers: it would wait for another state, and be stale there.
     *
     * @throws IllegalArgumentException if the state defers the event
     */
    void requireNotDeferred(Visit visit, Event event);

    /**
     * Why the visited state has no use for an event, whose name it does not have; empty if it has it. For people.
     */
    String unexpected(Visit visit, Event event);

    /**
     * Queues an event that the visit raises; waits while the queue is full.
     *
     * @throws InterruptedException if the thread is interrupted while it waits
     */
    void raise(Visit visit, Event event, Values values) throws InterruptedException;

    /**
     * Queues an event to be sent to the device; waits while the queue is full.
     *
     * @throws InterruptedException if the thread is interrupted while it waits
     */
    void send(Visit visit, Event event, Values values) throws InterruptedException;

    /**
     * Queues an event to be sent to the device, and has {@code then} called with its outcome; does not wait.
     *
     * @throws UnsupportedOperationException if nobody here learns of it
     */
    void ask(Visit visit, Event event, Values values, Consumer<EventOutcome> then);

    /**
     * Queues the last event of a visit even if the queue is full: it comes only once, possibly on the clock's thread,
     * which must not wait.
     */
    void finish(Visit visit, Event event, Values values);

    /** Writes a line into the transcript. */
    void notice(String line);

    /** The function failed. */
    void failed(Visit visit, Throwable cause);
}
