package org.evoloop.function;

import java.time.Duration;
import java.time.LocalTime;
import java.time.ZoneId;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import org.evoloop.evolution.EventOutcome;
import org.evoloop.evolution.Values;
import org.evoloop.statemachine.State;
import org.evoloop.time.Clock;
import org.evoloop.time.TimesOfDay;

/**
 * One visit of the evolved system to a state. Everything that belongs to a visit ends with it: its function, its
 * timers, and events that it raised and that have not been handled yet.
 *
 * <p>Threading: all methods may be called from any thread. Only the thread of the function and that of its tasks are
 * interrupted when the state is left; on any other, {@link #sleep}, {@link #raise} and {@link #send} wait on.
 *
 * @since 0.1
 */
public interface Visit {
    /** How a visit has begun. */
    enum Beginning {
        /** An event led into the state, or the new model followed the device there. */
        NEW,
        /**
         * The converter was stopped or its process ended during the visit, and it has been started again. Its device is
         * where the state needs it, if it needs it somewhere.
         */
        RESUMED,
        /** Other models have taken over during the visit, whether or not the function has been started again. */
        TAKEN_OVER
    }

    /** The visited state. */
    State state();

    /**
     * How the visit has begun, for a function that does something only once. A state that is entered again because it
     * could not be left keeps what it was. Always {@link Beginning#NEW} where the decisions of a fleet are carried out.
     */
    Beginning beginning();

    /**
     * Where the device is now: the state of the original model, as far as it has been reported. When the function of a
     * state with a device state starts, that is the device state.
     */
    State device();

    /** The number of the visit; no two are equal. */
    long number();

    /**
     * The values of the event with which the state was entered, also when it is entered again after it could not be
     * left, or after a stop; none after the program was restarted, and where the decisions of a fleet are carried out.
     */
    Values values();

    /** The converter's clock, by which all durations of a function are measured. */
    Clock clock();

    /** Whether functions have threads of their own; without, nothing may block. */
    boolean threads();

    /** Whether the state has not been left yet. */
    boolean isActive();

    /**
     * Waits until the state is left, which interrupts a function's own thread.
     *
     * @throws IllegalStateException in a converter without threads, where it would wait for itself
     */
    void awaitEnd() throws InterruptedException;

    /**
     * Waits for {@code duration}.
     *
     * @throws InterruptedException if the state is left first
     * @throws IllegalStateException in a converter without threads, and in a task of the clock, which would wait for
     *     itself
     * @throws IllegalArgumentException if {@code duration} is negative, or longer than {@link Clock#LONGEST}
     */
    void sleep(Duration duration) throws InterruptedException;

    /**
     * Whether the new model has a transition for {@code event} in this state: a function that can end in several ways
     * uses it to find out which of them its owner has drawn.
     */
    boolean accepts(String event);

    /** As {@link #raise(String, Values)}, without values. */
    default void raise(String event) throws InterruptedException {
        raise(event, Values.NONE);
    }

    /**
     * Raises {@code event} with {@code values} and continues; nothing happens if the state has been left.
     *
     * @throws InterruptedException if the state is left while this waits for room in the queue
     * @throws IllegalArgumentException if the state defers the event, which would be too late in any other state
     */
    void raise(String event, Values values) throws InterruptedException;

    /** As {@link #send(String, Values)}, without values. */
    default void send(String event) throws InterruptedException {
        send(event, Values.NONE);
    }

    /**
     * Sends {@code event} with {@code values} to the device and continues: the event waits for its turn like all
     * others, and the new model stays in this state. The state must declare that it sends the event, in its model or in
     * {@code StateKnowledge}, and the device's model must have a transition for it in the state of the device at that
     * time; else the event fails. The history shows the outcome. Nothing happens if the state has been left, or is left
     * first.
     *
     * @throws InterruptedException if the state is left while this waits for room in the queue
     */
    void send(String event, Values values) throws InterruptedException;

    /** As {@link #ask(String, Values)}, without values. */
    default CompletableFuture<EventOutcome> ask(String event) {
        return ask(event, Values.NONE);
    }

    /**
     * Sends {@code event} with {@code values} to the device, as {@link #send(String, Values)} does, without waiting, and
     * gives the outcome. A visit asks for one event at a time: until that is done, another is refused and not sent, so that
     * a loop cannot flood the device.
     *
     * @return completes when the record has moved, or it is certain that the event has no effect; on a thread of the JDK's
     *     common pool or, in a converter without threads, by the step that ends the event
     * @throws UnsupportedOperationException if the events of this converter are decided elsewhere, as in a fleet
     */
    CompletableFuture<EventOutcome> ask(String event, Values values);

    /** Reports the function's progress in a few words: as {@link #progress(String, List)}, without readings. */
    default void progress(String text) {
        progress(text, List.of());
    }

    /**
     * Reports the function's progress, in words and numbers. The converter's status shows the last report, and the
     * history shows the one with which the state was left. Cheap enough to be called 100 times a second.
     *
     * @param text for people, such as {@code looking around}
     * @param readings for people and programs, such as {@code distance 1.25 m}
     */
    void progress(String text, List<Reading> readings);

    /** The last reported progress; empty if there is none. */
    String progress();

    /** The last reported readings. */
    List<Reading> readings();

    /** As {@link #finish(String, Values)}, without values. */
    default void finish(String event) {
        finish(event, Values.NONE);
    }

    /**
     * Ends the function with {@code event} and its {@code values}, which is raised when {@link NewFunction#run} has
     * returned. Only the first call counts, and none after the state has been left. An event for which the state has no
     * transition does not end the function: it is reported at once as the function's failure.
     *
     * @throws IllegalArgumentException if the state defers the event, as {@link #raise(String, Values)}
     */
    void finish(String event, Values values);

    /**
     * Ends the function with {@code event} after {@code delay}, unless the state is left or it has finished before.
     *
     * @throws IllegalArgumentException if the state has no transition for the event, or defers it, and as {@link #after}
     */
    void finishAfter(Duration delay, String event);

    /**
     * Runs {@code task} after {@code delay}, unless the state is left first, on a thread that all tasks of this visit
     * share, or, in a converter without threads, on the clock's thread, where it must not wait. Its exceptions are
     * reported like the function's.
     *
     * @throws IllegalStateException if 10,000 tasks of this visit are waiting
     * @throws IllegalArgumentException if {@code delay} is negative, or longer than {@link Clock#LONGEST}
     */
    void after(Duration delay, Runnable task);

    /**
     * Runs {@code task} as {@link #after} does, when the time of day is next {@code time}, unless the state is left
     * first. For daylight saving time, a clock that is set and a computer that has slept, see {@link TimesOfDay}; times
     * that passed while the program was not running are not made up for.
     *
     * @param zone the time zone of {@code time}
     * @throws IllegalStateException as {@link #after}
     */
    void at(LocalTime time, ZoneId zone, Runnable task);

    /** As the method with a zone, in this computer's time zone. */
    default void at(LocalTime time, Runnable task) {
        at(time, ZoneId.systemDefault(), task);
    }

    /**
     * Runs {@code task} every day at {@code time} until the state is left; else as {@link #at(LocalTime, ZoneId,
     * Runnable)}.
     */
    void daily(LocalTime time, ZoneId zone, Runnable task);

    /** As the method with a zone, in this computer's time zone. */
    default void daily(LocalTime time, Runnable task) {
        daily(time, ZoneId.systemDefault(), task);
    }

    /**
     * Ends the function with {@code event} when the time of day is next {@code time}, unless the state is left or it
     * has finished before; else as {@link #at(LocalTime, ZoneId, Runnable)}.
     *
     * @throws IllegalArgumentException if the state has no transition for the event, or defers it
     */
    void finishAt(LocalTime time, ZoneId zone, String event);

    /** As the method with a zone, in this computer's time zone. */
    default void finishAt(LocalTime time, String event) {
        finishAt(time, ZoneId.systemDefault(), event);
    }

    /**
     * Reports that the function fails to do its work. Status, log and listeners show it as they show an exception of
     * the function, which continues: it ends with {@link #finish}. Nothing happens if the state has been left.
     *
     * @param reason for people, such as {@code not found within 300 s}
     */
    void failed(String reason);

    /** Writes {@code text} into the transcript. */
    void say(String text);

    /**
     * Runs {@code ending} when the state is left, in reverse order of registration, or at once if it has been left. An
     * ending must return by itself: nothing interrupts it.
     */
    void onEnd(Runnable ending);
}
