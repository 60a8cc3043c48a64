package org.evoloop.converter;

import static java.util.Objects.requireNonNull;

import java.util.ArrayList;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.function.Supplier;
import org.evoloop.evolution.DecisionTable;
import org.evoloop.evolution.Occurrence;
import org.evoloop.loop.Component;
import org.evoloop.loop.LoopConfig;
import org.evoloop.loop.LoopState;
import org.evoloop.loop.Threads;
import org.evoloop.statemachine.ModelException;
import org.jspecify.annotations.Nullable;

/**
 * An event converter: connects the components of a MAPE-K loop and controls them (paper, section V.A).
 *
 * <pre>{@code
 * SystemEventConverter converter = new SystemEventConverter(LoopConfig.defaults("lamp", clock));
 * converter.addMonitor(new WallSwitch());
 * converter.addExecute(new LampExecute());
 * converter.addKnowledge(new LampKnowledge(models));
 * converter.build();
 * converter.start();
 * }</pre>
 *
 * <p>Lifecycle: see {@link LoopState}. {@link #stop} ends the running new function and refuses events; {@link #start}
 * enters the current state anew and goes on from there.
 *
 * <p>Threading: all methods may be called from any thread, but those that change the converter not from its own.
 */
public final class SystemEventConverter implements AutoCloseable {
    private final LoopConfig config;
    private final Belongings belongings;
    private final Map<String, Supplier<? extends Component>> spares = new LinkedHashMap<>();
    private Assembly assembly = new Assembly();
    private @Nullable StateKnowledge knowledge;
    private @Nullable DeviceLink link;
    private volatile @Nullable ConverterCore core;

    /** @param config its options; they are checked by {@link #build} */
    public SystemEventConverter(LoopConfig config) {
        this.config = requireNonNull(config, "the converter's config is null");
        this.belongings = new Belongings(config.name());
    }

    /** Adds a monitor, also while the converter runs. @throws IllegalStateException if the name is taken */
    public synchronized void addMonitor(EventMonitor monitor) {
        add(monitor);
    }

    /** Sets the analyze component, in place of the usual one; before {@link #build}. */
    public synchronized void addAnalyze(DecisionAnalyze analyze) {
        add(analyze);
    }

    /** Sets the plan component, in place of the usual one; before {@link #build}. */
    public synchronized void addPlan(DecisionPlan plan) {
        add(plan);
    }

    /**
     * Adds an execute component, also while the converter runs.
     *
     * @throws IllegalStateException if the name is taken
     * @throws ModelException if it sends what the device does not know
     */
    public synchronized void addExecute(EventExecute execute) {
        add(execute);
    }

    /** Sets the knowledge, before {@link #build}. @throws IllegalStateException if there is one already */
    public synchronized void addKnowledge(StateKnowledge stateKnowledge) {
        requireNonNull(stateKnowledge, "the knowledge is null");
        if (knowledge != null) {
            throw new IllegalStateException("there is knowledge already, " + knowledge.name());
        }
        knowledge = stateKnowledge;
    }

    /** Tells what connects the device, for {@link #status}. */
    public synchronized void addLink(DeviceLink deviceLink) {
        link = requireNonNull(deviceLink, "the link is null");
    }

    /**
     * Keeps a component at hand for {@link #exchange(String, String)}, under a name of its own.
     *
     * @throws IllegalStateException if the name is taken
     */
    public synchronized void addSpare(String name, Supplier<? extends Component> spare) {
        requireNonNull(name, "the name of a spare is null");
        requireNonNull(spare, "the spare " + name + " is null");
        if (spares.putIfAbsent(name, spare) != null) {
            throw new IllegalStateException("there is a spare named " + name + " already");
        }
    }

    private void add(Component component) {
        requireNonNull(component, "the component is null");
        ConverterCore built = core;
        Assembly changed = assembly.with(component);
        if (built != null) {
            DecisionTable table = changed.decisions(built.knowledge);
            taking(component, () -> join(built, component));
            built.use(table, changed.executes());
        }
        assembly = changed;
    }

    /** Takes {@code component} for {@code change}; gives it back if that is refused. */
    private void taking(Component component, Runnable change) {
        belongings.take(component);
        try {
            change.run();
        } catch (RuntimeException refused) {
            belongings.giveBack(component);
            throw refused;
        }
    }

    /**
     * Checks everything, compiles the decisions of all configurations that can be reached, and gives every component its
     * thread.
     *
     * @throws ModelException if models and components do not fit; the message lists all problems
     * @throws IllegalStateException if something is missing or belongs to another converter, or this was done before
     * @throws IllegalArgumentException if an option is out of range; the message lists all of them
     */
    public synchronized void build() {
        StateKnowledge known = knowledge;
        if (core != null) {
            throw new IllegalStateException("converter " + config.name() + " has been built before");
        }
        List<String> missing = new ArrayList<>();
        if (known == null) {
            missing.add("no knowledge, call addKnowledge");
        }
        if (!assembly.has(Component.Role.EXECUTE)) {
            missing.add("no execute component, call addExecute");
        }
        if (known == null || !missing.isEmpty()) {
            throw new IllegalStateException("converter " + config.name() + ": " + String.join("; ", missing));
        }
        if (!assembly.has(Component.Role.ANALYZE)) {
            assembly.add(new DecisionAnalyze());
        }
        if (!assembly.has(Component.Role.PLAN)) {
            assembly.add(new DecisionPlan());
        }
        takeAll(known);
        try {
            core = build(known);
        } catch (RuntimeException refused) {
            belongings.giveBackAll(null);
            throw refused;
        }
    }

    private void takeAll(StateKnowledge known) {
        List<String> problems = new ArrayList<>();
        String another = "make one for each converter";
        belongings.take(config.clock(), "its clock", another, problems);
        belongings.take(known, known.name(), another, problems);
        for (Component component : assembly.all()) {
            belongings.take(component, component.name(), another, problems);
        }
        if (!problems.isEmpty()) {
            belongings.giveBackAll(null);
            throw new IllegalStateException("converter " + config.name() + ": " + String.join("; ", problems));
        }
    }

    private ConverterCore build(StateKnowledge known) {
        known.register();
        List<String> problems = new ArrayList<>(known.problems());
        ConverterCore built = new ConverterCore(config, known);
        try {
            built.use(assembly.decisions(known), assembly.executes());
        } catch (ModelException undecidable) {
            problems.add(undecidable.getMessage());
        }
        if (!problems.isEmpty()) {
            throw new ModelException(String.join("\n", problems));
        }
        for (Component component : assembly.all()) {
            join(built, component);
        }
        built.loop.build();
        return built;
    }

    private void join(ConverterCore built, Component component) {
        attach(built, component);
        if (component instanceof EventMonitor monitor) {
            built.loop.addMonitor(monitor);
        } else if (component instanceof DecisionAnalyze analyze) {
            built.loop.addAnalyze(analyze);
        } else if (component instanceof DecisionPlan plan) {
            built.loop.addPlan(plan);
        } else if (component instanceof EventExecute execute) {
            built.loop.addExecute(execute);
        }
    }

    private void attach(ConverterCore built, Component component) {
        if (component instanceof EventMonitor monitor) {
            monitor.attach(config, built.loop, built.knowledge.eventNames());
        } else if (component instanceof DecisionAnalyze analyze) {
            analyze.attach(built);
        } else if (component instanceof DecisionPlan plan) {
            plan.attach(built);
        } else if (!(component instanceof EventExecute)) {
            throw new IllegalArgumentException(component.name() + " is not a component of a converter");
        }
    }

    /** Opens the loop; does nothing if it is open. @throws IllegalStateException if it is not built, or has ended */
    public synchronized void start() {
        ConverterCore built = built();
        if (built.loop.state() != LoopState.RUNNING) {
            built.start();
        }
    }

    /**
     * Closes the loop: the event that is in it comes to its end, those that wait are refused, and the running new function
     * ends. Then the execute components let go of the device. Does nothing if it is closed.
     */
    public synchronized void stop() {
        ConverterCore built = built();
        if (built.loop.state() == LoopState.RUNNING) {
            built.loop.stop();
            built.release();
        }
    }

    /**
     * Ends the converter and its threads, see {@link org.evoloop.loop.MapeLoop#close}. Idempotent. Called by a component, a
     * function or a task of a visit it returns at once, and the converter ends when its caller has returned.
     */
    @Override
    public void close() {
        ConverterCore built = core;
        if (built != null && config.threads() && built.ownsCurrentThread()) {
            Threads.start("converter-" + config.name() + "-close", this::end);
        } else {
            end();
        }
    }

    private synchronized void end() {
        ConverterCore built = core;
        if (built != null) {
            boolean wasRunning = built.loop.state() == LoopState.RUNNING;
            built.loop.close();
            if (wasRunning) {
                built.release();
            }
            belongings.giveBackAll(built.knowledge);
        }
    }

    /**
     * Removes a component.
     *
     * @throws IllegalArgumentException if there is none of that name
     * @throws IllegalStateException if the converter needs it
     * @throws ModelException if decisions are left that nobody could carry out
     */
    public synchronized void remove(String name) {
        ConverterCore built = built();
        Assembly changed = assembly.without(name);
        DecisionTable table =
                changed.has(Component.Role.EXECUTE) ? changed.decisions(built.knowledge) : built.knowledge.table();
        built.loop.remove(name);
        belongings.giveBack(assembly.require(name));
        assembly = changed;
        built.use(table, changed.executes());
    }

    /**
     * Puts {@code next} in the place of the component {@code name}, between two events.
     *
     * @throws IllegalArgumentException if there is none of that name, or it has another role
     * @throws ModelException if decisions are left that nobody could carry out
     */
    public synchronized void exchange(String name, Component next) {
        ConverterCore built = built();
        requireNonNull(next, "what shall take the place of " + name + " is null");
        built.loop.requireExchangeable(name, next);
        Assembly changed = assembly.with(name, next);
        DecisionTable table = changed.decisions(built.knowledge);
        taking(next, () -> {
            attach(built, next);
            built.loop.exchange(name, next);
        });
        belongings.giveBack(assembly.require(name));
        assembly = changed;
        built.use(table, changed.executes());
    }

    /**
     * Puts a spare in the place of the component {@code name}, between two events.
     *
     * @param spare as named by {@link #addSpare}
     * @throws IllegalArgumentException if there is no such component or spare, or their roles differ
     */
    public synchronized void exchange(String name, String spare) {
        Supplier<? extends Component> supplier = spares.get(spare);
        if (supplier == null) {
            throw new IllegalArgumentException("no spare is named " + spare + "; there are "
                    + (spares.isEmpty() ? "none" : String.join(", ", spares.keySet())));
        }
        exchange(name, requireNonNull(supplier.get(), "the spare " + spare + " is null"));
    }

    /** The names of the spares, in the order in which they were added. */
    public synchronized Set<String> spares() {
        return Collections.unmodifiableSet(new LinkedHashSet<>(spares.keySet()));
    }

    /** Queues an occurrence as if a monitor had told it; false if it was refused or dropped. */
    public boolean offer(Occurrence occurrence) {
        return built().loop.offer(occurrence);
    }

    /**
     * The step of a monitor in a converter without threads: asks it once and queues what it tells.
     *
     * @throws IllegalStateException if the converter has threads, which ask its monitors
     * @throws IllegalArgumentException if {@code monitor} is none of this converter
     */
    public void observe(EventMonitor monitor) throws InterruptedException {
        built().loop.observe(monitor);
    }

    /** The step of a converter without threads: converts one event that waits; false if none does. */
    public boolean step() {
        return built().loop.step();
    }

    /** What the converter knows. @throws IllegalStateException if it is not built yet */
    public StateKnowledge knowledge() {
        return built().knowledge;
    }

    /** A picture of this moment. @throws IllegalStateException if the converter is not built yet */
    public ConverterStatus status() {
        ConverterCore built = built();
        DeviceLink device = link;
        return new ConverterStatus(
                config.name(),
                built.loop.state(),
                built.knowledge.configuration(),
                built.loop.queueStatus(),
                built.history.counts(),
                built.latency.summary(),
                built.loop.components(),
                built.visits.runningFunction(),
                device == null ? null : new ConverterStatus.Link(device.isUp(), device.describe()));
    }

    /** The last events and what became of them, oldest first. */
    public List<HistoryEntry> history() {
        return built().history.entries();
    }

    private ConverterCore built() {
        ConverterCore built = core;
        if (built == null) {
            throw new IllegalStateException("converter " + config.name() + " is not built yet");
        }
        return built;
    }
}
