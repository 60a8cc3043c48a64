package org.evoloop.function;

import static java.util.Objects.requireNonNull;

import java.time.Duration;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.State;
import org.evoloop.time.Clock;
import org.jspecify.annotations.Nullable;

/**
 * One stay of the evolved system in a state. What belongs to a visit ends with it: its function, its timers, and the
 * events it has raised that were not handled yet.
 *
 * <p>Threading: all methods may be called from any thread.
 */
public final class Visit {
    private final State state;
    private final long number;
    private final VisitHost host;
    private final Object lock = new Object();
    private volatile boolean ended;
    private volatile String progress = "";

    // Made when they are needed: most visits need neither.
    private @Nullable List<Clock.Timer> timers;
    private @Nullable Deque<Runnable> endings;
    private boolean running;
    private @Nullable Event last;
    private boolean finished;

    /** @param number counts the visits of all states, from 1 */
    public Visit(State state, long number, VisitHost host) {
        this.state = state;
        this.number = number;
        this.host = host;
    }

    /** The state that is visited. */
    public State state() {
        return state;
    }

    /** The number of the visit; no two are equal. */
    public long number() {
        return number;
    }

    /** The converter's time; durations of a function are durations of this clock. */
    public Clock clock() {
        return host.clock();
    }

    /** Whether functions have threads of their own; without, nothing may block. */
    public boolean threads() {
        return host.threads();
    }

    /** Whether the state has not been left yet. */
    public boolean isActive() {
        return !ended;
    }

    /**
     * Waits until the state is left, which a function's own thread learns by an interrupt.
     *
     * @throws IllegalStateException in a converter without threads, which would wait for itself
     */
    public void awaitEnd() throws InterruptedException {
        requireThreads("awaitEnd", "onEnd");
        synchronized (lock) {
            while (!ended) {
                lock.wait();
            }
        }
    }

    /**
     * Waits for {@code duration}.
     *
     * @throws InterruptedException if the state is left first
     * @throws IllegalStateException in a converter without threads, and in a task of the clock, which would wait for itself
     * @throws IllegalArgumentException if {@code duration} is negative, or longer than {@link Clock#LONGEST}
     */
    public void sleep(Duration duration) throws InterruptedException {
        requireThreads("sleep", "after or finishAfter");
        host.clock().sleep(duration);
    }

    private void requireThreads(String method, String instead) {
        if (!threads()) {
            throw new IllegalStateException(
                    "visit." + method + " would wait for ever: the converter has no threads; use " + instead);
        }
    }

    /**
     * Whether the new model has a transition for {@code event} in this state: a function that can end in several ways asks
     * which of them its owner has drawn.
     */
    public boolean accepts(String event) {
        return host.accepts(this, new Event(event));
    }

    /**
     * Raises {@code event} and continues; nothing happens if the state has been left.
     *
     * @throws InterruptedException if the state is left while this waits for room in the queue
     */
    public void raise(String event) throws InterruptedException {
        if (isActive()) {
            host.raise(this, new Event(event));
        }
    }

    /**
     * Has the device take {@code event}, which its model must know in the state in which the device is by then, and
     * continues: the event waits for its turn like all others, and the new model stays in this state. The history shows
     * what became of it. Nothing happens if the state has been left, or is left first.
     *
     * @throws InterruptedException if the state is left while this waits for room in the queue
     */
    public void send(String event) throws InterruptedException {
        if (isActive()) {
            host.send(this, new Event(event));
        }
    }

    /** Describes in a short line how far the function is; shown in the converter's status. */
    public void progress(String text) {
        progress = text;
    }

    /** The last text given to {@link #progress(String)}; empty if there is none. */
    public String progress() {
        return progress;
    }

    /**
     * Ends the function with {@code event}, its last: the event is raised when {@link NewFunction#run} has returned. Only
     * the first call counts, and none once the state has been left.
     */
    public void finish(String event) {
        synchronized (lock) {
            if (finished || !isActive()) {
                return;
            }
            finished = true;
            last = new Event(event);
            if (running) {
                return;
            }
        }
        deliverLast();
    }

    /**
     * Ends the function with {@code event} after {@code delay}, unless the state is left or it has finished before.
     *
     * @throws IllegalArgumentException if neither model knows the event, and as {@link #after}
     */
    public void finishAfter(Duration delay, String event) {
        host.requireKnown(new Event(event));
        after(delay, () -> finish(event));
    }

    /**
     * Runs {@code task} on the clock's thread, where it must not wait, after {@code delay}, unless the state is left first.
     * What it throws is reported like what the function throws.
     *
     * @throws IllegalArgumentException if {@code delay} is negative, or longer than {@link Clock#LONGEST}
     */
    public void after(Duration delay, Runnable task) {
        Clock.requireDelay(requireNonNull(delay, "the delay is null"));
        requireNonNull(task, "the task is null");
        synchronized (lock) {
            if (isActive()) {
                List<Clock.Timer> all = timers == null ? new ArrayList<>() : timers;
                timers = all;
                all.add(host.clock().schedule(delay, () -> {
                    if (isActive()) {
                        contained(task);
                    }
                }));
            }
        }
    }

    /** Writes {@code text} into the transcript. */
    public void say(String text) {
        if (isActive()) {
            host.notice("***  " + text + "  ***  ");
        }
    }

    /**
     * Runs {@code ending} when the state is left, in reverse order of registration, or at once if it has been left. An
     * ending must return by itself: nothing interrupts it.
     */
    public void onEnd(Runnable ending) {
        requireNonNull(ending, "the ending is null");
        synchronized (lock) {
            if (isActive()) {
                Deque<Runnable> all = endings == null ? new ArrayDeque<>() : endings;
                endings = all;
                all.push(ending);
                return;
            }
        }
        contained(ending);
    }

    /** Calls {@code function} and delivers its last event. */
    void run(NewFunction function) {
        synchronized (lock) {
            running = true;
        }
        try {
            function.run(this);
        } catch (InterruptedException stop) {
            if (isActive()) {
                host.failed(this, stop);
            }
        } catch (Throwable cause) {
            host.failed(this, cause);
        }
        synchronized (lock) {
            running = false;
        }
        deliverLast();
    }

    private void deliverLast() {
        Event event;
        synchronized (lock) {
            event = last;
            last = null;
        }
        if (event != null && isActive()) {
            host.notice("***  Send " + event + " event to EventConverter.  ***  ");
            host.notice("***  Stop new functions  ***");
            host.finish(this, event);
        }
    }

    /** The state is left: timers are called off and endings run. Idempotent. */
    void end() {
        List<Clock.Timer> toCancel;
        Deque<Runnable> toRun;
        synchronized (lock) {
            ended = true;
            lock.notifyAll();
            toCancel = timers;
            timers = null;
            toRun = endings;
            endings = null;
        }
        if (toCancel != null) {
            toCancel.forEach(Clock.Timer::cancel);
        }
        if (toRun != null) {
            toRun.forEach(this::contained);
        }
    }

    /** A task that throws must not disturb the clock's thread, nor the thread that leaves the state. */
    private void contained(Runnable task) {
        try {
            task.run();
        } catch (Throwable cause) {
            host.failed(this, cause);
        }
    }

    /** For messages: {@code visit 3 of Move}. */
    @Override
    public String toString() {
        return "visit " + number + " of " + state;
    }
}
