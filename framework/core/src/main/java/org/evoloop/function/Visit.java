package org.evoloop.function;

import java.time.Duration;
import java.time.LocalTime;
import java.time.ZoneId;
import java.util.List;
import org.evoloop.statemachine.State;
import org.evoloop.time.Clock;
import org.evoloop.time.TimesOfDay;

/**
 * One stay of the evolved system in a state. What belongs to a visit ends with it: its function, its timers, and the
 * events it has raised that were not handled yet.
 *
 * <p>Threading: all methods may be called from any thread.
 *
 * @since 0.1
 */
public interface Visit {
    /** The state that is visited. */
    State state();

    /** The number of the visit; no two are equal. */
    long number();

    /** The converter's time; durations of a function are durations of this clock. */
    Clock clock();

    /** Whether functions have threads of their own; without, nothing may block. */
    boolean threads();

    /** Whether the state has not been left yet. */
    boolean isActive();

    /**
     * Waits until the state is left, which a function's own thread learns by an interrupt.
     *
     * @throws IllegalStateException in a converter without threads, which would wait for itself
     */
    void awaitEnd() throws InterruptedException;

    /**
     * Waits for {@code duration}.
     *
     * @throws InterruptedException if the state is left first
     * @throws IllegalStateException in a converter without threads, and in a task of the clock, which would wait for itself
     * @throws IllegalArgumentException if {@code duration} is negative, or longer than {@link Clock#LONGEST}
     */
    void sleep(Duration duration) throws InterruptedException;

    /**
     * Whether the new model has a transition for {@code event} in this state: a function that can end in several ways asks
     * which of them its owner has drawn.
     */
    boolean accepts(String event);

    /**
     * Raises {@code event} and continues; nothing happens if the state has been left.
     *
     * @throws InterruptedException if the state is left while this waits for room in the queue
     */
    void raise(String event) throws InterruptedException;

    /**
     * Has the device take {@code event}, which its model must know in the state in which the device is by then, and
     * continues: the event waits for its turn like all others, and the new model stays in this state. The history shows
     * what became of it. Nothing happens if the state has been left, or is left first.
     *
     * @throws InterruptedException if the state is left while this waits for room in the queue
     */
    void send(String event) throws InterruptedException;

    /** Says in a few words how far the function is: as {@link #progress(String, List)}, without readings. */
    default void progress(String text) {
        progress(text, List.of());
    }

    /**
     * Says how far the function is, in words and numbers: the converter's status shows the last that was said, and the
     * history where the function was when its state was left. Cheap enough to be called 100 times a second.
     *
     * @param text for people, such as {@code looking around}
     * @param readings for people and programs, such as {@code distance 1.25 m}
     */
    void progress(String text, List<Reading> readings);

    /** What was said last; empty if nothing was. */
    String progress();

    /** The readings that were given last. */
    List<Reading> readings();

    /**
     * Ends the function with {@code event}, its last: the event is raised when {@link NewFunction#run} has returned. Only
     * the first call counts, and none once the state has been left.
     */
    void finish(String event);

    /**
     * Ends the function with {@code event} after {@code delay}, unless the state is left or it has finished before.
     *
     * @throws IllegalArgumentException if neither model knows the event, and as {@link #after}
     */
    void finishAfter(Duration delay, String event);

    /**
     * Runs {@code task} after {@code delay}, unless the state is left first, on a thread that all tasks of this visit share;
     * in a converter without threads on the clock's, where it must not wait. What it throws is reported like what the
     * function throws.
     *
     * @throws IllegalStateException if 10,000 tasks of this visit wait for their time
     * @throws IllegalArgumentException if {@code delay} is negative, or longer than {@link Clock#LONGEST}
     */
    void after(Duration delay, Runnable task);

    /**
     * Runs {@code task} as {@link #after} does, when the clock on the wall next shows {@code time}, unless the state is left first.
     * Summer time, a clock that is set and a computer that has slept are dealt with as {@link TimesOfDay} says; what came while
     * the program did not run is not made up for.
     *
     * @param zone whose time of day counts
     * @throws IllegalStateException as {@link #after}
     */
    void at(LocalTime time, ZoneId zone, Runnable task);

    /** The same by this computer's time of day. */
    default void at(LocalTime time, Runnable task) {
        at(time, ZoneId.systemDefault(), task);
    }

    /** Runs {@code task} every day at {@code time} until the state is left; else as {@link #at(LocalTime, ZoneId, Runnable)}. */
    void daily(LocalTime time, ZoneId zone, Runnable task);

    /** The same by this computer's time of day. */
    default void daily(LocalTime time, Runnable task) {
        daily(time, ZoneId.systemDefault(), task);
    }

    /**
     * Ends the function with {@code event} when the clock on the wall next shows {@code time}, unless the state is left or it has
     * finished before; else as {@link #at(LocalTime, ZoneId, Runnable)}.
     *
     * @throws IllegalArgumentException if neither model knows the event
     */
    void finishAt(LocalTime time, ZoneId zone, String event);

    /** The same by this computer's time of day. */
    default void finishAt(LocalTime time, String event) {
        finishAt(time, ZoneId.systemDefault(), event);
    }

    /** Writes {@code text} into the transcript. */
    void say(String text);

    /**
     * Runs {@code ending} when the state is left, in reverse order of registration, or at once if it has been left. An
     * ending must return by itself: nothing interrupts it.
     */
    void onEnd(Runnable ending);
}
