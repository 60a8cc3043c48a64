package org.evoloop.converter.running;

import java.time.Duration;
import java.time.Instant;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.concurrent.atomic.AtomicReference;
import java.util.function.BooleanSupplier;
import java.util.stream.Stream;
import org.evoloop.converter.Analysis;
import org.evoloop.converter.ChangePlan;
import org.evoloop.converter.ConverterJournal;
import org.evoloop.converter.ConverterStatus;
import org.evoloop.converter.DeviceLink;
import org.evoloop.converter.EventAnalyze;
import org.evoloop.converter.EventExecute;
import org.evoloop.converter.EventMonitor;
import org.evoloop.converter.EventPlan;
import org.evoloop.converter.Evolution;
import org.evoloop.converter.EvolutionException;
import org.evoloop.converter.Probation;
import org.evoloop.converter.Prospect;
import org.evoloop.converter.ShadowReport;
import org.evoloop.converter.StateKnowledge;
import org.evoloop.converter.UnknownEffectException;
import org.evoloop.converter.attachment.ExecuteAccess;
import org.evoloop.converter.attachment.Friends;
import org.evoloop.converter.attachment.KnowledgeAccess;
import org.evoloop.converter.recording.FailureLog;
import org.evoloop.converter.recording.Listeners;
import org.evoloop.converter.recording.Records;
import org.evoloop.engine.Output;
import org.evoloop.engine.Rules;
import org.evoloop.engine.Swap;
import org.evoloop.evolution.Configuration;
import org.evoloop.evolution.DecisionTable;
import org.evoloop.evolution.EventNames;
import org.evoloop.evolution.Occurrence;
import org.evoloop.evolution.Sentry;
import org.evoloop.loop.Component;
import org.evoloop.loop.Failure;
import org.evoloop.loop.LoopConfig;
import org.evoloop.loop.LoopListener;
import org.evoloop.loop.LoopState;
import org.evoloop.loop.MapeLoop;
import org.evoloop.migration.Fate;
import org.evoloop.statemachine.Event;
import org.jspecify.annotations.Nullable;

/**
 * Everything around the core of a running converter: the loop that brings its inputs, the components that carry out its
 * directives, and the records of its outputs.
 *
 * <p>Threading: the loop calls it for one event at a time.
 */
public final class ConverterShell implements LoopListener<Occurrence> {
    /**
     * How long a takeover attempt may wait for the event in the loop, holding up all others, before it gives up and
     * tries later.
     */
    private static final Duration LONGEST_WAIT = Duration.ofSeconds(1);

    /** A component that refuses this many events in a row is probably faulty. */
    private static final int MOST_NULLS = 50;

    private final LoopConfig config;
    private final CurrentKnowledge knowledge;
    private final Records records;
    private final MapeLoop<Occurrence, Analysis, ChangePlan> loop;
    private final Visits visits;
    private final CoreDriver driver;
    private final Senders senders;
    private final PlanExecutor executor;
    private final Hooks hooks;

    /** What monitors say that controllers raise. */
    private volatile Set<Event> reported = Set.of();

    /** Whether it was opened and has not released the device since. */
    private volatile boolean holdsDevice;

    public ConverterShell(
            LoopConfig config,
            StateKnowledge first,
            DecisionTable table,
            FailureLog failures,
            Listeners listeners,
            BooleanSupplier closing,
            @Nullable ConverterJournal journal,
            Sentry.@Nullable Posting posting) {
        this.config = config;
        this.knowledge = new CurrentKnowledge(first);
        this.records = new Records(config, failures, listeners);
        this.hooks = new Hooks(config, closing);
        this.visits = new Visits(config, knowledge, records.transcript(), records.failures());
        SentryFeed sentryFeed = new SentryFeed(config.clock(), posting);
        this.driver = new CoreDriver(
                new Rules(table, knowledge.access()::timersOf, config.queueCapacity(), config.pressAge()),
                config.clock(),
                knowledge,
                records,
                visits::leaving,
                journal,
                sentryFeed);
        this.senders = new Senders(driver);
        this.executor = new PlanExecutor(driver, senders, visits, knowledge, records, this::failed);
        this.loop = new MapeLoop<>(config, this, senders, new CoreIntake(driver, sentryFeed));
        senders.attach(loop::isStuck);
        executor.attach(loop::look);
        visits.attach(loop, records.listeners().endings());
        sentryFeed.attach(driver, loop::offer);
        adopt(first);
    }

    private void adopt(StateKnowledge adopted) {
        KnowledgeAccess access = Friends.KNOWLEDGE.of(adopted);
        access.bindings().watch(config, records.failures()::fault);
        access.attach(driver::configuration);
    }

    /** Its loop. */
    public MapeLoop<Occurrence, Analysis, ChangePlan> loop() {
        return loop;
    }

    /** Its core. */
    public CoreDriver driver() {
        return driver;
    }

    /** Its records. */
    public Records records() {
        return records;
    }

    /** The events that its components can send. */
    public Set<Event> sendable() {
        return senders.sendable();
    }

    /** The events that a controller may raise. */
    public Set<Event> controllerEvents() {
        return ControllerEvents.of(knowledge(), sendable(), reported);
    }

    /** What can happen next. */
    public Prospect prospect() {
        return driver.prospects(knowledge(), controllerEvents()).compute();
    }

    /** Its present knowledge. */
    public StateKnowledge knowledge() {
        return knowledge.get();
    }

    /**
     * Lets other knowledge take over; the caller notifies the listeners.
     *
     * @param idle how long nothing must have happened before
     * @param monitors that report events by name
     * @throws EvolutionException if that is not possible now
     */
    public Evolution.Result evolve(Swap swap, StateKnowledge next, Duration idle, List<EventMonitor> monitors) {
        AtomicReference<Evolution.@Nullable Result> result = new AtomicReference<>();
        loop.between(LONGEST_WAIT, () -> result.set(take(swap, next, idle, monitors)));
        Evolution.Result done = result.get();
        if (done == null) {
            throw new EvolutionException("an event is in progress");
        }
        return done;
    }

    /**
     * Starts a shadow.
     *
     * @throws EvolutionException if that is not possible now
     */
    public void shadow(Swap swap, Probation.Watches watches) {
        AtomicBoolean begun = new AtomicBoolean();
        loop.between(LONGEST_WAIT, () -> {
            driver.shadow(swap, watches);
            begun.set(true);
        });
        if (!begun.get()) {
            throw new EvolutionException("an event is in progress");
        }
    }

    private Evolution.Result take(Swap swap, StateKnowledge next, Duration idle, List<EventMonitor> monitors) {
        long begun = config.clock().nanoTime();
        StateKnowledge before = knowledge.get();
        Output.Evolved evolved = driver.evolve(swap, next, idle);
        adopt(next);
        Friends.KNOWLEDGE.of(before).attach(null);
        EventNames names = knowledge.access().eventNames();
        monitors.forEach(monitor -> Friends.MONITOR.of(monitor).useNames(names));
        visits.becomes(evolved.fate().at().evolved());
        executor.carryOut();
        Fate.Maps fate = evolved.fate();
        return new Evolution.Result(
                evolved.occurrence().model(),
                evolved.before(),
                fate.to(),
                fate.steps(),
                fate.carried(),
                Duration.ofNanos(config.clock().nanoTime() - begun));
    }

    /** Adds a component and attaches it. */
    public void join(Component component) {
        attach(component);
        if (component instanceof EventMonitor monitor) {
            loop.addMonitor(monitor);
        } else if (component instanceof EventAnalyze analyze) {
            loop.addAnalyze(analyze);
        } else if (component instanceof EventPlan plan) {
            loop.addPlan(plan);
        } else if (component instanceof EventExecute execute) {
            loop.addExecute(execute);
        }
    }

    /** Attaches a component to this converter. */
    public void attach(Component component) {
        if (component instanceof EventMonitor monitor) {
            Friends.MONITOR
                    .of(monitor)
                    .attach(
                            config,
                            loop,
                            knowledge.access().eventNames(),
                            driver::holding,
                            event -> driver.rules().table().isDevicesOwn(event),
                            records.listeners().endings());
        } else if (component instanceof EventAnalyze analyze) {
            Friends.ANALYZE.of(analyze).accept(driver);
        } else if (component instanceof EventPlan plan) {
            Friends.PLAN.of(plan).accept(driver);
        } else if (component instanceof EventExecute execute) {
            Friends.EXECUTE.of(execute).attach(executor, config);
        } else {
            throw new IllegalArgumentException(component.name() + " is not a component of a converter");
        }
    }

    /** From the next event on, decides by {@code table}. */
    public void use(DecisionTable table, Assembly present) {
        driver.use(table);
        senders.use(present.executes());
        reported = present.reportedOfControllers();
    }

    /** Opens the loop, after every execute component has prepared the device for the current state. */
    public void start() {
        holdsDevice = true;
        for (ExecuteAccess execute : senders.all()) {
            hook(execute, "settled", config.stepLimit(), () -> execute.settled(driver.configuration()));
        }
        driver.watch();
        loop.start(executor::carryOut);
    }

    /** Whether it still has to release the device. */
    public boolean holdsDevice() {
        return holdsDevice;
    }

    /** Whether the caller is a component, a function or the clock. Code called by one of these must not wait for it. */
    public boolean ownsCurrentThread() {
        return loop.ownsCurrentThread()
                || visits.ownsCurrentThread()
                || hooks.ownsCurrentThread()
                || config.clock().ownsCurrentThread();
    }

    /** Whether the caller is a component whose hook is called while the converter is opened or closed. */
    public boolean callsHook() {
        return hooks.ownsCurrentThread();
    }

    /** Ends the current visit and releases the device; the loop is closed. */
    public void release() {
        driver.release();
        // The function may take the join limit to end, and then its endings run.
        Duration limit = config.joinLimit().multipliedBy(2);
        String hangs = hooks.call(limit, executor::carryOut);
        if (!hangs.isEmpty()) {
            executor.abandon();
            records.failures()
                    .fault("end of a visit", new Failure<>("visit", "onEnd", 0, null, Hooks.late(limit, hangs)));
        }
        for (ExecuteAccess execute : senders.all()) {
            hook(execute, "released", config.joinLimit(), execute::released);
        }
        holdsDevice = false;
    }

    private interface Hook {
        void run() throws Exception;
    }

    /** Outside of the loop. */
    private void hook(ExecuteAccess execute, String phase, Duration limit, Hook hook) {
        String hangs = hooks.call(limit, () -> {
            try {
                hook.run();
            } catch (Throwable cause) {
                failed(execute, phase, cause);
            }
        });
        if (!hangs.isEmpty()) {
            failed(execute, phase, Hooks.late(limit, hangs));
        }
    }

    private void failed(ExecuteAccess execute, String phase, Throwable cause) {
        if (cause instanceof InterruptedException) {
            Thread.currentThread().interrupt();
            return;
        }
        Failure<Occurrence> failure = new Failure<>(execute.name(), phase, 0, null, cause);
        loop.count(failure);
        report(failure);
    }

    private void report(Failure<Occurrence> failure) {
        records.failures().log(failure);
        records.listeners().failed(failure);
    }

    ConverterStatus.EventCounts counts() {
        return driver.counts();
    }

    // LoopListener

    @Override
    public void failed(Failure<Occurrence> failure) {
        ends(failure, failure.cause() instanceof UnknownEffectException);
    }

    /**
     * A snapshot of the status.
     *
     * @param evolution see {@link ConverterStatus#evolution}
     * @param link the connection to the device, if one was registered
     * @param closedAt when the loop was last closed
     */
    public ConverterStatus status(String evolution, @Nullable DeviceLink link, Instant closedAt) {
        Optional<Instant> closed = loop.state() == LoopState.RUNNING ? Optional.empty() : Optional.of(closedAt);
        Optional<Instant> down = link == null ? Optional.empty() : link.downSince();
        ShadowReport shadow = driver.shadowReport();
        Configuration now = driver.configuration();
        return new ConverterStatus(
                config.name(),
                loop.state(),
                now,
                driver.rules().table().models().describe(now),
                evolution,
                shadow == null ? "" : shadow.toString(),
                driver.doubt(),
                driver.drift(),
                Stream.concat(closed.stream(), down.stream()).min(Comparator.naturalOrder()),
                loop.queueStatus(),
                counts(),
                driver.conversionTime(),
                loop.components(),
                visits.runningFunction(),
                closed.isPresent() ? List.of() : visits.runningTimers(driver.deadlines()),
                records.failures().faults(),
                link == null ? null : new ConverterStatus.LinkStatus(link.isUp(), link.describe(), link.readings()));
    }

    @Override
    public void givenUp(Failure<Occurrence> failure) {
        blame(failure);
        ends(failure, true);
    }

    @Override
    public void returnedNull(String component, String role, int inARow, Occurrence about) {
        executor.dismiss(about);
        if (inARow % MOST_NULLS == 0) {
            Failure<Occurrence> failure = new Failure<>(
                    component,
                    role,
                    0,
                    null,
                    new Exception("has returned null " + MOST_NULLS
                            + " times in a row, so these events were ignored; exchange it if that is not meant"));
            loop.count(failure);
            report(failure);
        }
    }

    /** Counts a failure of the code that an unresponsive component was calling. */
    private void blame(Failure<Occurrence> failure) {
        for (String guard : knowledge.bindings().asked()) {
            records.failures().note("guard [" + guard + "]", failure);
        }
        String effect = executor.runningEffect();
        if (!effect.isEmpty()) {
            records.failures().note("effect " + effect, failure);
        }
    }

    /** @param unknown whether it is uncertain if the step being sent had its effect */
    private void ends(Failure<Occurrence> failure, boolean unknown) {
        report(failure);
        Occurrence occurrence = failure.occurrence();
        if (occurrence != null) {
            executor.breakOff(occurrence, failure.toString(), unknown);
        }
    }

    @Override
    public void dropped(Occurrence occurrence, boolean first) {
        if (first) {
            records.failures()
                    .warn("the queue of " + config.queueCapacity()
                            + " events is full, and events are lost; status counts them, history names them");
        }
    }
}
