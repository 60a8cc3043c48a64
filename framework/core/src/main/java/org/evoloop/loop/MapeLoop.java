package org.evoloop.loop;

import static java.util.Objects.requireNonNull;

import java.time.Duration;
import java.util.List;
import org.evoloop.time.Threads;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * A MAPE-K loop of one or more monitors, one analyze, one plan and one or more execute components.
 *
 * <p>Lifecycle: see {@link LoopState}. The threads ({@link ThreadingModel}) live from {@link #build} until the loop is
 * {@link #close closed}, a component's own thread from when it is added until it is removed; {@link #start} and {@link
 * #stop} open and close the loop any number of times.
 *
 * <p>An occurrence that a monitor reports waits in a bounded queue. One occurrence at a time goes through analyze, plan
 * and execute; the next one is taken when the last execute component has returned. Components may be added, removed and
 * exchanged at any time: that happens between two occurrences, and one that does not end in time is given up.
 *
 * <p>Errors: exceptions of a component are reported to the {@link LoopListener} and counted, and the loop continues.
 *
 * <p>Threading: all methods may be called from any thread, but those that change the loop not from the loop's own
 * threads.
 *
 * @param <O> an occurrence
 * @param <A> an analysis
 * @param <P> a plan
 * @since 0.1
 */
public final class MapeLoop<O, A, P> implements AutoCloseable {
    private static final Logger LOG = LoggerFactory.getLogger(MapeLoop.class);

    private final LoopConfig config;
    private final Pipeline<O, A, P> pipeline;
    private final Sequencer<O> sequencer;
    private final Gate<O> gate;
    private final Roster<O, A, P> roster;
    private final Object admin = new Object();

    /**
     * A loop that hands each plan to every execute component and drops any occurrence that finds the queue full.
     *
     * @throws IllegalArgumentException if an option is out of range; the message lists all of them
     */
    public MapeLoop(LoopConfig config, LoopListener<O> listener) {
        this(config, listener, Dispatch.toEach(), new PlainQueue<>(config.queueCapacity()));
    }

    /**
     * @param dispatch chooses the execute component that takes a plan
     * @param intake the queue of occurrences
     * @throws IllegalArgumentException if an option is out of range; the message lists all of them
     */
    public MapeLoop(LoopConfig config, LoopListener<O> listener, Dispatch<P> dispatch, Intake<O> intake) {
        if (!config.problems().isEmpty()) {
            throw new IllegalArgumentException(String.join("; ", config.problems()));
        }
        this.config = config;
        LoopLock lock = new LoopLock();
        this.pipeline = new Pipeline<>(config.name(), dispatch);
        this.sequencer = new Sequencer<>(config, listener, intake, pipeline, lock);
        this.gate = new Gate<>(config, sequencer, lock);
        this.roster = new Roster<>(config, pipeline, sequencer);
    }

    /**
     * Adds a monitor.
     *
     * @throws IllegalStateException if the loop has ended or the name is taken
     */
    public void addMonitor(Monitor<O> monitor) {
        add(monitor);
    }

    /**
     * Sets the analyze component.
     *
     * @throws IllegalStateException if there is one already, or the loop has ended
     */
    public void addAnalyze(Analyze<O, A> analyze) {
        add(analyze);
    }

    /**
     * Sets the plan component.
     *
     * @throws IllegalStateException if there is one already, or the loop has ended
     */
    public void addPlan(Plan<A, P> plan) {
        add(plan);
    }

    /**
     * Adds an execute component.
     *
     * @throws IllegalStateException if the loop has ended or the name is taken
     */
    public void addExecute(Execute<P> execute) {
        add(execute);
    }

    private void add(Component added) {
        synchronized (admin) {
            requireUsable();
            requireUnknown(added);
            gate.quietlyUnlessInterrupted(() -> enlist(added, Integer.MAX_VALUE));
        }
    }

    private void requireUnknown(Component added) {
        if (roster.find(added.name()) != null) {
            throw new IllegalStateException(
                    "there is a component named " + added.name() + " already; give one of them another name");
        }
    }

    private void enlist(Component component, int position) {
        Worker worker = roster.enlist(component, position);
        if (sequencer.state() != LoopState.NEW) {
            worker.start();
        }
    }

    private void requireUsable() {
        if (sequencer.state() == LoopState.EXITED) {
            throw new IllegalStateException("the loop " + config.name() + " has ended");
        }
        if (ownsCurrentThread()) {
            throw new IllegalStateException("a loop cannot be changed from its own thread "
                    + Thread.currentThread().getName() + "; hand the change to another thread");
        }
    }

    /**
     * Whether the caller is a thread of this loop, or of a loop made on such a thread, also after its component was
     * given up or removed.
     */
    public boolean ownsCurrentThread() {
        return roster.ownsCurrentThread();
    }

    /**
     * Removes a component; a thread of its own ends.
     *
     * @throws IllegalArgumentException if there is none of that name
     * @throws IllegalStateException if the loop needs it: only monitors may all go
     */
    public void remove(String name) {
        remove(name, () -> {});
    }

    /**
     * As {@link #remove(String)}; {@code meanwhile}, which must be quick, runs before the next occurrence is taken from
     * the queue.
     */
    public void remove(String name, Runnable meanwhile) {
        synchronized (admin) {
            requireUsable();
            Worker worker = roster.require(name);
            if (roster.needs(worker)) {
                throw new IllegalStateException(name + " is the only component of the role "
                        + worker.component().role() + "; exchange it instead");
            }
            gate.quietlyUnlessInterrupted(() -> {
                roster.drop(worker);
                meanwhile.run();
            });
            awaitEnd(worker.threadToEnd());
        }
    }

    /**
     * Replaces the component {@code name} by {@code next}, between two occurrences.
     *
     * @throws IllegalArgumentException if there is none of that name, or it has another role
     * @throws IllegalStateException if the loop has ended, or {@code next} is part of it already
     */
    public void exchange(String name, Component next) {
        exchange(name, next, () -> {});
    }

    /**
     * As {@link #exchange(String, Component)}; {@code meanwhile}, which must be quick, runs before the next occurrence
     * is taken from the queue.
     */
    public void exchange(String name, Component next, Runnable meanwhile) {
        synchronized (admin) {
            requireUsable();
            requireExchangeable(name, next);
            Worker worker = roster.require(name);
            gate.quietlyUnlessInterrupted(() -> {
                enlist(next, roster.drop(worker));
                meanwhile.run();
            });
            awaitEnd(worker.threadToEnd());
        }
    }

    /**
     * Runs {@code change}, which may call user code, between two occurrences: none is in the loop, and none begins
     * meanwhile.
     *
     * @param limit how long to wait for the occurrence in the loop
     * @return whether it ended in time; if not, {@code change} was not run
     * @throws IllegalStateException if the loop has ended, or the caller is one of its threads
     */
    public boolean between(Duration limit, Runnable change) {
        synchronized (admin) {
            requireUsable();
            return gate.between(limit, change);
        }
    }

    /** Throws what {@link #exchange} would throw for these two, before anything is changed. */
    public void requireExchangeable(String name, Component next) {
        Component old = roster.require(name).component();
        if (old.role() != next.role()) {
            throw new IllegalArgumentException(name + " is a component of the role " + old.role() + ", " + next.name()
                    + " of the role " + next.role());
        }
        if (!next.name().equals(name)) {
            requireUnknown(next);
        }
    }

    /**
     * Starts the threads.
     *
     * @throws IllegalStateException if a component is missing or the loop has been built already; the message lists all
     *     problems
     */
    public void build() {
        build(LoopState.STOPPED);
    }

    /** As {@link #build}, and opens the loop before any monitor is called, so that no reported event is refused. */
    public void buildAndStart() {
        build(LoopState.RUNNING);
    }

    private void build(LoopState first) {
        synchronized (admin) {
            List<String> problems = roster.problems();
            if (sequencer.state() != LoopState.NEW) {
                problems.add("it has been built before");
            }
            if (!problems.isEmpty()) {
                throw new IllegalStateException("loop " + config.name() + ": " + String.join("; ", problems));
            }
            gate.become(first);
            roster.start();
        }
    }

    /**
     * Opens the loop. Does nothing if it is open.
     *
     * @throws IllegalStateException if it is not built, or has ended
     */
    public void start() {
        start(() -> {});
    }

    /**
     * As {@link #start()}; {@code beginning} runs before the first occurrence is taken from the queue, and occurrences
     * that come meanwhile wait. It does not run if the loop is open already.
     */
    public void start(Runnable beginning) {
        synchronized (admin) {
            requireUsable();
            if (sequencer.state() == LoopState.NEW) {
                throw new IllegalStateException("the loop " + config.name() + " is not built yet");
            }
            if (sequencer.state() != LoopState.RUNNING) {
                gate.open(beginning);
            }
        }
    }

    /**
     * Closes the loop: the occurrence in it is completed, those that wait are refused. Does nothing if it is closed.
     */
    public void stop() {
        if (sequencer.state() == LoopState.RUNNING) {
            requireUsable();
            shut();
            awaitQuiet();
        }
    }

    /**
     * Closes the loop at once, on any thread and even if something hangs: nothing begins any more, and waiting
     * occurrences are refused. Call {@link #awaitQuiet} afterwards. Does nothing if it is closed.
     */
    public void shut() {
        gate.shut();
    }

    /** After {@link #shut}: waits until the occurrence in the loop has ended or been given up. */
    public void awaitQuiet() {
        synchronized (admin) {
            if (sequencer.state() == LoopState.STOPPED) {
                requireUsable();
                gate.quietly(() -> {});
            }
        }
    }

    /**
     * Ends the loop and its threads. Waits for each up to the join limit and names in the log any that does not end.
     * Idempotent; an interrupt of the caller does not cut it short. When called by a component, it returns at once, and
     * the loop ends after that component has returned.
     */
    @Override
    public void close() {
        if (ownsCurrentThread()) {
            // The end waits for this very thread.
            Threads.start("mapek-" + config.name() + "-close", this::end);
        } else {
            end();
        }
    }

    private void end() {
        synchronized (admin) {
            if (sequencer.state() != LoopState.EXITED) {
                // First the state, then the wait: nothing new may begin while the last occurrence ends.
                gate.become(LoopState.EXITED);
                gate.quietly(roster::retire);
                roster.threads().forEach(this::awaitEnd);
            }
        }
    }

    private void awaitEnd(@Nullable LoopThread thread) {
        if (thread != null && !thread.join(config.joinLimit())) {
            LOG.warn(
                    "thread {} did not end within {} ms; its component ignores interrupts",
                    thread.name(),
                    config.joinLimit().toMillis());
        }
    }

    /** Queues an occurrence as if a monitor had reported it; false if it was refused or dropped. */
    public boolean offer(O occurrence) {
        return admit(occurrence) == Intake.Admission.TAKEN;
    }

    /** As {@link #offer}, with the reason if it is not taken. */
    public Intake.Admission admit(O occurrence) {
        return sequencer.offer(requireNonNull(occurrence, "the occurrence is null"));
    }

    /**
     * Queues an occurrence reported by a monitor of this loop, on the caller's thread instead of the monitor's.
     *
     * @return null if that has to be left to the monitor: the loop is not built yet, or the monitor is not part of it
     */
    public Intake.@Nullable Admission report(Monitor<O> monitor, O occurrence) {
        if (sequencer.state() == LoopState.NEW || roster.workerOf(monitor) == null) {
            return null;
        }
        return sequencer.offer(occurrence);
    }

    /**
     * Queues an occurrence that must not be lost: waits while the queue has no room for it.
     *
     * @return false if the loop is closed, or closes meanwhile
     */
    public boolean put(O occurrence) throws InterruptedException {
        return sequencer.put(occurrence);
    }

    /** Begins the next occurrence if nothing is in the loop: the intake may hold one that was not offered. */
    public void look() {
        sequencer.look();
    }

    /**
     * Calls one monitor once and queues what it reports, on the caller's thread: the step of a monitor in a loop
     * without threads.
     *
     * @throws IllegalStateException if the loop has threads
     * @throws IllegalArgumentException if {@code monitor} is not part of the loop
     */
    public void observe(Monitor<O> monitor) throws InterruptedException {
        requireStepped();
        MonitorWorker<O> worker = roster.workerOf(monitor);
        if (worker == null) {
            throw new IllegalArgumentException(monitor.name() + " is not part of the loop " + config.name());
        }
        worker.observe();
    }

    private void requireStepped() {
        if (config.threads()) {
            throw new IllegalStateException("the loop " + config.name() + " has threads; they take the steps");
        }
    }

    /**
     * Takes one occurrence from the queue through analyze, plan and execute, on the caller's thread: the step of a loop
     * without threads.
     *
     * @return false if nothing waited or the loop is closed
     * @throws IllegalStateException if the loop has threads
     */
    public boolean step() {
        requireStepped();
        return sequencer.step();
    }

    /** Whether {@code monitor} is part of this loop. */
    public boolean has(Monitor<O> monitor) {
        return roster.workerOf(monitor) != null;
    }

    /** Whether {@code execute} was given up and has not returned; what is left to it fails. */
    public boolean isStuck(Execute<P> execute) {
        return pipeline.isStuck(execute);
    }

    /** The state of the loop's lifecycle. */
    public LoopState state() {
        return sequencer.state();
    }

    /** The status of the queue. */
    public QueueStatus queueStatus() {
        return sequencer.queueStatus();
    }

    /** Counts a failure outside the loop as one of the component that it names, if that is part of the loop. */
    public void count(Failure<O> failure) {
        Worker worker = roster.find(failure.component());
        if (worker != null) {
            worker.countFailure(failure.toString());
        }
    }

    /** Every component, in the order of the loop. */
    public List<ComponentStatus> components() {
        return roster.workers().stream().map(Worker::status).toList();
    }
}
