package org.evoloop.function.visit;

import static java.util.Objects.requireNonNull;

import java.time.Duration;
import java.time.LocalTime;
import java.time.ZoneId;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.atomic.AtomicReference;
import org.evoloop.evolution.EventOutcome;
import org.evoloop.evolution.Values;
import org.evoloop.function.NewFunction;
import org.evoloop.function.Reading;
import org.evoloop.function.Visit;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.State;
import org.evoloop.time.Clock;
import org.jspecify.annotations.Nullable;

/**
 * A visit in a converter, which takes the events that the visit raises.
 *
 * <p>Threading: all methods may be called from any thread.
 */
public final class HostedVisit implements Visit {
    /** The most tasks that may wait at once. */
    static final int MOST_TIMERS = 10_000;

    private volatile State state;
    private volatile Beginning beginning;
    private final long number;
    private final Values values;
    private final VisitHost host;
    // Guards the fields below that are not volatile. Never held while user code runs, which may wait for a thread that
    // needs it.
    private final Object lock = new Object();
    private volatile boolean ended;

    /** The function's reported progress. */
    private record Said(String text, List<Reading> readings) {
        static final Said NOTHING = new Said("", List.of());
    }

    /** The event with which the function ends. */
    private record Last(Event event, Values values) {}

    /** A scheduled task; can be cancelled until its time has come. */
    private final class Appointment implements Runnable {
        private final Runnable task;
        Clock.@Nullable Timer timer;

        Appointment(Runnable task) {
            this.task = task;
        }

        @Override
        public void run() {
            synchronized (lock) {
                if (timers != null) {
                    // Before the task: it may set the next appointment, which must find room.
                    timers.remove(this);
                }
            }
            if (isActive()) {
                task.run();
            }
        }
    }

    /** The event that it has asked for; null while there is none. */
    private final AtomicReference<@Nullable Event> asking = new AtomicReference<>();

    private volatile Said said = Said.NOTHING;

    // Made when they are needed: most visits need neither.
    private @Nullable Set<Appointment> timers;
    private @Nullable VisitTasks tasks;
    private @Nullable Deque<Runnable> endings;
    private boolean running;
    private @Nullable Last last;
    private boolean finished;

    /**
     * @param number counts the visits of all states, from 1
     * @param values those of the event with which the state was entered
     */
    public HostedVisit(State state, Beginning beginning, long number, Values values, VisitHost host) {
        this.state = state;
        this.beginning = beginning;
        this.number = number;
        this.values = values;
        this.host = host;
    }

    /** Continues the visit in a state of other models. */
    public void goOnIn(State next) {
        state = next;
        beginning = Beginning.TAKEN_OVER;
    }

    @Override
    public State state() {
        return state;
    }

    @Override
    public Beginning beginning() {
        return beginning;
    }

    @Override
    public long number() {
        return number;
    }

    @Override
    public Values values() {
        return values;
    }

    @Override
    public Clock clock() {
        return host.clock();
    }

    @Override
    public boolean threads() {
        return host.threads();
    }

    @Override
    public boolean isActive() {
        return !ended;
    }

    @Override
    public void awaitEnd() throws InterruptedException {
        requireThreads("awaitEnd", "onEnd");
        synchronized (lock) {
            while (!ended) {
                lock.wait();
            }
        }
    }

    @Override
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

    @Override
    public State device() {
        return host.device();
    }

    @Override
    public boolean accepts(String event) {
        return host.accepts(this, new Event(event));
    }

    @Override
    public void raise(String event, Values carried) throws InterruptedException {
        if (isActive()) {
            Event raised = new Event(event);
            host.requireNotDeferred(this, raised);
            host.raise(this, raised, requireNonNull(carried, "the values are null"));
        }
    }

    @Override
    public void send(String event, Values carried) throws InterruptedException {
        if (isActive()) {
            host.send(this, new Event(event), requireNonNull(carried, "the values are null"));
        }
    }

    @Override
    public CompletableFuture<EventOutcome> ask(String event, Values carried) {
        Event asked = new Event(event);
        CompletableFuture<EventOutcome> outcome = new CompletableFuture<>();
        if (!isActive()) {
            outcome.complete(new EventOutcome.Stale("the state has been left"));
        } else if (asking.compareAndSet(null, asked)) {
            // Free for the next question before the future completes: what hangs on it may ask at once.
            host.ask(this, asked, requireNonNull(carried, "the values are null"), ended -> {
                asking.set(null);
                outcome.complete(ended);
            });
        } else {
            outcome.complete(new EventOutcome.Refused(
                    "this visit has asked for an event that is not done yet; wait for its outcome"));
        }
        return outcome;
    }

    @Override
    public void progress(String text, List<Reading> readings) {
        said = new Said(requireNonNull(text, "the text is null"), List.copyOf(readings));
    }

    @Override
    public String progress() {
        return said.text();
    }

    @Override
    public List<Reading> readings() {
        return said.readings();
    }

    @Override
    public void finish(String event, Values carried) {
        Last ending = new Last(new Event(event), requireNonNull(carried, "the values are null"));
        if (isActive()) {
            host.requireNotDeferred(this, ending.event());
            String unexpected = host.unexpected(this, ending.event());
            if (!unexpected.isEmpty()) {
                // Reported here: on a thread that is not the function's, nobody may hear of an exception.
                host.failed(this, new IllegalArgumentException(unexpected));
                return;
            }
        }
        finish(ending);
    }

    private void finish(Last ending) {
        synchronized (lock) {
            if (finished || !isActive()) {
                return;
            }
            finished = true;
            last = ending;
            // Delivered when the function returns: now, the loop would leave the state and interrupt it half-way.
            if (running) {
                return;
            }
        }
        deliverLast();
    }

    @Override
    public void finishAfter(Duration delay, String event) {
        Last ending = lastOnClock(event);
        onClock(delay, () -> finish(ending));
    }

    @Override
    public void after(Duration delay, Runnable task) {
        onClock(delay, asTask(task));
    }

    @Override
    public void at(LocalTime time, ZoneId zone, Runnable task) {
        new Alarm(this, time, zone, asTask(task)).once();
    }

    @Override
    public void daily(LocalTime time, ZoneId zone, Runnable task) {
        new Alarm(this, time, zone, asTask(task)).daily();
    }

    @Override
    public void finishAt(LocalTime time, ZoneId zone, String event) {
        Last ending = lastOnClock(event);
        new Alarm(this, time, zone, () -> finish(ending)).once();
    }

    /** The clock cannot be told what is wrong with an event, so that is found out before. */
    private Last lastOnClock(String event) {
        Last ending = new Last(new Event(event), Values.NONE);
        host.requireKnown(ending.event());
        host.requireNotDeferred(this, ending.event());
        String unexpected = host.unexpected(this, ending.event());
        if (!unexpected.isEmpty()) {
            throw new IllegalArgumentException(unexpected);
        }
        return ending;
    }

    /** What the clock runs for {@code task}. */
    private Runnable asTask(Runnable task) {
        requireNonNull(task, "the task is null");
        Runnable unlessOver = () -> {
            if (isActive()) {
                contained(task);
            }
        };
        return threads() ? () -> tasks().run(unlessOver) : unlessOver;
    }

    private VisitTasks tasks() {
        synchronized (lock) {
            VisitTasks made = tasks == null ? new VisitTasks(this, host) : tasks;
            tasks = made;
            if (ended) {
                // The visit ended while the task was on its way here: nobody else would end this thread.
                made.end();
            }
            return made;
        }
    }

    /**
     * As {@link #after}, for tasks that are not a function's: {@code task} neither waits nor throws, and runs on the
     * clock's thread.
     *
     * @throws IllegalStateException if {@value #MOST_TIMERS} are pending
     */
    public void onClock(Duration delay, Runnable task) {
        Clock.requireDelay(requireNonNull(delay, "the delay is null"));
        synchronized (lock) {
            if (!isActive()) {
                return;
            }
            // Most visits have one timer: room for more would be garbage in every event.
            Set<Appointment> all = timers == null ? new HashSet<>(2) : timers;
            timers = all;
            if (all.size() + (tasks == null ? 0 : tasks.waiting()) >= MOST_TIMERS) {
                throw new IllegalStateException(this + " waits for " + MOST_TIMERS
                        + " times already; set the next one when one of them has " + "passed");
            }
            Appointment appointment = new Appointment(task);
            all.add(appointment);
            // Under the lock, so that end() finds the timer that it has to cancel.
            appointment.timer = host.clock().schedule(delay, appointment);
        }
    }

    @Override
    public void failed(String reason) {
        requireNonNull(reason, "the reason is null");
        if (isActive()) {
            host.failed(this, new Exception(reason));
        }
    }

    @Override
    public void say(String text) {
        if (isActive()) {
            host.notice("***  " + text + "  ***  ");
        }
    }

    @Override
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
            if (ended) {
                // It was left before its thread ran; by now another visit may have begun.
                return;
            }
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
        Last ending;
        synchronized (lock) {
            ending = last;
            // Taken out, so that of two threads that come here one delivers it.
            last = null;
        }
        if (ending != null && isActive()) {
            host.notice("***  Send " + ending.event() + " event to EventConverter.  ***  ");
            host.notice("***  Stop new functions  ***");
            host.finish(this, ending.event(), ending.values());
        }
    }

    /** The state is left: cancels timers and runs endings. Idempotent. */
    void end() {
        Set<Appointment> toCancel;
        VisitTasks toEnd;
        Deque<Runnable> toRun;
        synchronized (lock) {
            ended = true;
            lock.notifyAll();
            // Only taken here: cancelling and the endings may take long, and run without the lock.
            toCancel = timers;
            timers = null;
            toEnd = tasks;
            toRun = endings;
            endings = null;
        }
        if (toCancel != null) {
            for (Appointment appointment : toCancel) {
                Clock.Timer timer = appointment.timer;
                if (timer != null) {
                    timer.cancel();
                }
            }
        }
        if (toEnd != null) {
            toEnd.end();
        }
        if (toRun != null) {
            toRun.forEach(this::contained);
        }
    }

    /**
     * After {@link #end}: waits for the running task. Returns its thread if the task does not return in time; else
     * null.
     */
    @Nullable
    Thread awaitTasks(Duration limit) {
        VisitTasks ending;
        synchronized (lock) {
            ending = tasks;
        }
        return ending == null ? null : ending.awaitEnd(limit);
    }

    /** The thread in which a task hangs; empty if none does. */
    String hangsIn() {
        VisitTasks running;
        synchronized (lock) {
            running = tasks;
        }
        return running == null ? "" : running.hangsIn();
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
