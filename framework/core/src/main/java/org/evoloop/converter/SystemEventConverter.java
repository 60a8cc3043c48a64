package org.evoloop.converter;

import static java.util.Objects.requireNonNull;

import java.time.Instant;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.function.Function;
import java.util.function.Supplier;
import org.evoloop.core.Sentry;
import org.evoloop.evolution.ModelPair;
import org.evoloop.evolution.Occurrence;
import org.evoloop.loop.Component;
import org.evoloop.loop.LoopConfig;
import org.evoloop.loop.LoopState;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.ModelException;
import org.evoloop.time.Clock;
import org.evoloop.time.Threads;
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
 * enters the current state again and continues from there.
 *
 * <p>Threading: all methods may be called from any thread; components cannot change the converter, but may {@link #stop} and
 * {@link #close} it, and functions, tasks of visits and listeners may change it too.
 *
 * @since 0.1
 */
public final class SystemEventConverter implements AutoCloseable {
    /** The most events that {@link #history(int)} returns at once. */
    public static final int MOST_HISTORY = 100_000;

    private final LoopConfig config;
    private final Belongings belongings;
    private final Spares spares = new Spares();
    private final FailureLog failures;
    private final Listeners listeners;
    private final ChangeLock changes;
    private final Stopping stopping;
    private final Evolver evolver;
    private final Crewing crewing;
    private @Nullable StateKnowledge knowledge;
    private volatile @Nullable Function<ModelPair, ? extends StateKnowledge> knowledgeFactory;
    private volatile @Nullable DeviceLink link;
    private @Nullable ConverterJournal journal;
    private Sentry.@Nullable Posting posting;
    private volatile @Nullable ConverterShell shell;

    /** When the loop was closed last, or built. */
    private volatile Instant closedAt = Instant.EPOCH;

    /** @param config its options; they are checked by {@link #build} */
    public SystemEventConverter(LoopConfig config) {
        this.config = requireNonNull(config, "the converter's config is null");
        this.belongings = new Belongings(config.name());
        this.failures = new FailureLog(config);
        this.listeners = new Listeners(config, failures);
        this.changes = new ChangeLock(config.name(), this::isComponent, this::ownsCurrentThread);
        this.stopping = new Stopping(config.name());
        this.crewing = new Crewing(belongings);
        this.evolver = new Evolver(config, changes, belongings, crewing::present);
    }

    /** Adds a monitor, also while the converter runs. @throws IllegalStateException if the name is taken */
    public void addMonitor(EventMonitor monitor) {
        add(monitor);
    }

    /** Sets the analyze component, in place of the usual one; before {@link #build}. */
    public void addAnalyze(EventAnalyze analyze) {
        add(analyze);
    }

    /** Sets the plan component, in place of the usual one; before {@link #build}. */
    public void addPlan(EventPlan plan) {
        add(plan);
    }

    /**
     * Adds an execute component, also while the converter runs.
     *
     * @throws IllegalStateException if the name is taken
     * @throws ModelException if it sends what the device does not know
     */
    public void addExecute(EventExecute execute) {
        add(execute);
    }

    /** Sets the knowledge, before {@link #build}. @throws IllegalStateException if there is one already */
    public void addKnowledge(StateKnowledge stateKnowledge) {
        requireNonNull(stateKnowledge, "the knowledge is null");
        changes.change(() -> {
            if (knowledge != null) {
                throw new IllegalStateException("there is knowledge already, " + knowledge.name());
            }
            knowledge = stateKnowledge;
        });
    }

    /**
     * Says how knowledge is made of other models, before {@link #build}: those to which a converter had evolved before its
     * process ended, and those that {@link #knowledgeOf} is asked for.
     */
    public void addKnowledgeFactory(Function<ModelPair, ? extends StateKnowledge> factory) {
        requireNonNull(factory, "the knowledge factory is null");
        changes.change(() -> knowledgeFactory = factory);
    }

    /**
     * Makes knowledge of other models, to {@link #evolve} to.
     *
     * @throws IllegalStateException if it was not said how, see {@link #addKnowledgeFactory}
     * @throws ModelException if the models are no evolution
     */
    public StateKnowledge knowledgeOf(ModelPair models) {
        return Construction.knowledgeOf(models, knowledgeFactory);
    }

    /** From now on {@code listener} is notified of what this converter does. */
    public void addListener(ConverterListener listener) {
        listeners.add(listener);
    }

    /** {@code listener} is not notified any more, but for a call that is being made. Does nothing if it is none. */
    public void removeListener(ConverterListener listener) {
        listeners.remove(listener);
    }

    /**
     * Records this converter's inputs, before {@link #build}; that begins where the process before this one has ended.
     * Events that waited still wait, and the one in progress goes on after the steps that were sent, as soon as the converter
     * is started. A step that may or may not have been sent is not sent again: the record is in doubt, see
     * {@link EventExecute#locate}.
     *
     * @throws IllegalStateException if it has been built, or has a journal already
     */
    public void journal(ConverterJournal kept) {
        requireNonNull(kept, "the journal is null");
        changes.change(() -> {
            if (shell != null || journal != null) {
                throw new IllegalStateException("converter " + config.name()
                        + (shell != null ? " has been built before" : " has a journal already"));
            }
            journal = kept;
        });
    }

    /**
     * Has a sentry watch this converter from each start on, and from each time at which other models take over. What it finds
     * to be violated is an event of the history that has failed.
     *
     * @throws IllegalStateException if it has been built, or is watched already
     */
    public void watch(Sentry.Posting sentries) {
        changes.change(() -> {
            if (shell != null || posting != null) {
                throw new IllegalStateException(
                        "converter " + config.name() + " has been built, or is watched already");
            }
            posting = requireNonNull(sentries, "the sentries are null");
        });
    }

    private void closeJournal() {
        if (journal != null) {
            journal.close();
        }
    }

    /** Registers the connection to the device, for {@link #status}. */
    public void addLink(DeviceLink deviceLink) {
        link = requireNonNull(deviceLink, "the link is null");
    }

    /**
     * Keeps a component at hand for {@link #exchange(String, String)}, under a name of its own.
     *
     * @throws IllegalStateException if the name is taken
     */
    public void addSpare(String name, Supplier<? extends Component> spare) {
        spares.add(name, spare);
    }

    private void add(Component component) {
        requireNonNull(component, "the component is null");
        changes.change(() -> crewing.add(shell, component));
    }

    /**
     * Checks everything, compiles the decisions of all configurations that can be reached, and gives every component its
     * thread.
     *
     * @throws ModelException if models and components do not fit; the message lists all problems
     * @throws IllegalStateException if something is missing or belongs to another converter, or this was done before
     * @throws IllegalArgumentException if an option is out of range; the message lists all of them
     * @throws RuntimeException if the journal cannot be gone on with; the message says why and what to do
     */
    public void build() {
        changes.change(this::buildInTurn);
    }

    private void buildInTurn() {
        StateKnowledge known = knowledge;
        if (shell != null) {
            throw new IllegalStateException("converter " + config.name() + " has been built before");
        }
        Construction construction = new Construction(config, belongings, crewing.present());
        StateKnowledge complete = construction.complete(known);
        try {
            StateKnowledge present = construction.present(complete, journal, knowledgeFactory);
            evolver.resumed(complete, present);
            shell = construction.build(
                    present,
                    present != complete,
                    table -> new ConverterShell(
                            config, present, table, failures, listeners, changes::isClosing, journal, posting));
            closedAt = config.clock().wallTime();
        } catch (RuntimeException refused) {
            belongings.giveBackAll(null);
            closeJournal();
            throw refused;
        }
    }

    /** Opens the loop; does nothing if it is open. @throws IllegalStateException if it is not built, or has ended */
    public void start() {
        ConverterShell built = built();
        stopping.await(ownsCurrentThread());
        changes.change(() -> {
            if (built.loop.state() != LoopState.RUNNING) {
                built.start();
            }
        });
    }

    /**
     * Closes the loop: from now on nothing begins, and events that wait are refused. The event that is in it comes to its
     * end, and the running new function ends; then the execute components let go of the device. That is waited for as long
     * as a person waits for an answer, 100 ms: what takes longer follows by itself, and what hangs
     * is given up. Does nothing if it is closed. Called by a component, a function, a task of a visit or a listener it does
     * not wait at all.
     *
     * @return whether all of it has been done; false if something has not returned yet
     */
    public boolean stop() {
        ConverterShell built = built();
        if (!built.holdsDevice()) {
            return true;
        }
        built.loop.shut();
        Runnable rest = () -> changes.change(() -> {
            // If it was just being opened.
            built.loop.shut();
            letGo(built);
        });
        if (!config.threads()) {
            rest.run();
            return true;
        }
        return stopping.begin(rest, ownsCurrentThread());
    }

    /** After the loop was closed. */
    private void letGo(ConverterShell built) {
        if (built.holdsDevice()) {
            built.loop.awaitQuiet();
            closedAt = config.clock().wallTime();
            built.release();
        }
    }

    /** Whether the caller is a component, a function or the clock, for which nobody must wait who was called by them. */
    private boolean ownsCurrentThread() {
        ConverterShell built = shell;
        return listeners.ownsCurrentThread() || (built != null && built.ownsCurrentThread());
    }

    /** Whether the caller must not even wait for its turn to change the converter: every change waits for it. */
    private boolean isComponent() {
        ConverterShell built = shell;
        return built != null && (built.loop.ownsCurrentThread() || built.hooks.ownsCurrentThread());
    }

    /**
     * Ends the converter and its threads, see {@link org.evoloop.loop.MapeLoop#close}. Idempotent. Called by a component, a
     * function, a task of a visit or a listener it returns at once, and the converter ends when its caller has returned.
     */
    @Override
    public void close() {
        if (config.threads() && ownsCurrentThread()) {
            Threads.start("converter-" + config.name() + "-close", this::end);
        } else {
            end();
        }
    }

    private void end() {
        changes.close(() -> {
            ConverterShell built = shell;
            if (built != null) {
                built.loop.close();
                letGo(built);
                belongings.giveBackAll(built.knowledge());
            }
            closeJournal();
        });
        listeners.close();
        stopping.await(false);
    }

    /**
     * Removes a component.
     *
     * @throws IllegalArgumentException if there is no component of that name
     * @throws IllegalStateException if the converter needs it
     * @throws ModelException if a decision could then not be carried out
     */
    public void remove(String name) {
        ConverterShell built = built();
        changes.change(() -> crewing.remove(built, name));
    }

    /**
     * Puts {@code next} in the place of the component {@code name}, between two events.
     *
     * @throws IllegalArgumentException if there is no component of that name, or it has another role
     * @throws ModelException if a decision could then not be carried out
     */
    public void exchange(String name, Component next) {
        ConverterShell built = built();
        requireNonNull(next, "what shall take the place of " + name + " is null");
        changes.change(() -> crewing.exchange(built, name, next));
    }

    /**
     * Puts a spare in the place of the component {@code name}, between two events.
     *
     * @param spare as named by {@link #addSpare}
     * @throws IllegalArgumentException if there is no such component or spare, or their roles differ
     */
    public void exchange(String name, String spare) {
        exchange(name, spares.make(spare));
    }

    /** The names of the spares, in the order in which they were added. */
    public Set<String> spares() {
        return spares.names();
    }

    /**
     * Puts other models, and what is known with them, in the place of the present ones, between two events: no event is
     * lost, none is heard twice, and timers keep what is left of them. Waits until that is possible; in a converter without
     * threads it must be possible at once. Until something else is changed, {@link #rollBack} leads back.
     *
     * @return what became of the current states
     * @throws ModelException if the models are no evolution, do not fit the components, or cannot take over from where the
     *     system is; or if no way would lead back, and the evolution does not say that none has to
     * @throws EvolutionException if it was not possible in time; the message says what was in the way, and nothing has changed
     * @throws IllegalStateException if the converter has ended, or {@code next} belongs to another converter
     */
    public Evolution.Result evolve(Evolution evolution) {
        return evolver.evolve(built(), evolution);
    }

    /**
     * Puts the models before the last {@link #evolve} back, in the same way; after a start, those with which it was built.
     *
     * @throws IllegalStateException if there was none, or it was one without a way back
     * @throws EvolutionException as in {@link #evolve}
     */
    public Evolution.Result rollBack() {
        return evolver.rollBack(built(), "as its owner asked for");
    }

    /**
     * Tells other models the same from now on, and compares what they make of it. A shadow before it ends.
     *
     * @param evolution by which {@link Shadow#promote} puts them in
     * @throws ModelException as in {@link #evolve}
     * @throws EvolutionException if they have no place for where the system is at this moment
     */
    public Shadow shadow(Evolution evolution) {
        return evolver.shadow(built(), evolution);
    }

    /** The shadow that has not ended. */
    public Optional<Shadow> shadow() {
        return Optional.ofNullable(evolver.shadow());
    }

    /** Queues an occurrence as if a monitor had reported it; false if it was refused or dropped. */
    public boolean offer(Occurrence occurrence) {
        return built().loop.offer(occurrence);
    }

    /**
     * The step of a monitor in a converter without threads: calls it once and queues what it returns.
     *
     * @throws IllegalStateException if the converter has threads, which call its monitors
     * @throws IllegalArgumentException if {@code monitor} does not belong to this converter
     */
    public void observe(EventMonitor monitor) throws InterruptedException {
        built().loop.observe(monitor);
    }

    /** The step of a converter without threads: converts one event that waits; false if none does. */
    public boolean step() {
        boolean stepped = built().loop.step();
        evolver.stepped();
        return stepped;
    }

    /** The time that it goes by. */
    public Clock clock() {
        return config.clock();
    }

    /** What the converter knows. @throws IllegalStateException if it is not built yet */
    public StateKnowledge knowledge() {
        return built().knowledge();
    }

    /** The events that its execute components can send to the device. @throws IllegalStateException if it is not built yet */
    public Set<Event> sendableEvents() {
        return built().carrier.sendable();
    }

    /** A snapshot of the status. @throws IllegalStateException if the converter is not built yet */
    public ConverterStatus status() {
        return built().status(evolver.describe(knowledge()), link, closedAt);
    }

    /** The last events and what became of them, oldest first. */
    public List<HistoryEntry> history() {
        return built().driver.history();
    }

    /**
     * The same, and those before them that the journal has; reading it takes some seconds if it is large.
     *
     * @param count how many at most, 1 to {@value #MOST_HISTORY}
     * @throws IllegalArgumentException if it is another number
     * @throws RuntimeException if the journal cannot be read; the message says why and what to do
     */
    public List<HistoryEntry> history(int count) {
        if (count < 1 || count > MOST_HISTORY) {
            throw new IllegalArgumentException("history tells of 1 to " + MOST_HISTORY + " events, not of " + count);
        }
        return built().driver.history(count);
    }

    private ConverterShell built() {
        ConverterShell built = shell;
        if (built == null) {
            throw new IllegalStateException("converter " + config.name() + " is not built yet");
        }
        return built;
    }
}
