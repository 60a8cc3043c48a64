package org.evoloop.converter.changing;

import static java.util.Objects.requireNonNull;

import java.time.Duration;
import java.time.Instant;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.function.Function;
import java.util.function.Supplier;
import org.evoloop.converter.ConverterDelegate;
import org.evoloop.converter.ConverterJournal;
import org.evoloop.converter.ConverterListener;
import org.evoloop.converter.ConverterStatus;
import org.evoloop.converter.DeviceLink;
import org.evoloop.converter.EventMonitor;
import org.evoloop.converter.Evolution;
import org.evoloop.converter.HistoryEntry;
import org.evoloop.converter.Prospect;
import org.evoloop.converter.Shadow;
import org.evoloop.converter.StateKnowledge;
import org.evoloop.converter.SystemEventConverter;
import org.evoloop.converter.recording.FailureLog;
import org.evoloop.converter.recording.Listeners;
import org.evoloop.converter.running.ConverterShell;
import org.evoloop.evolution.ModelPair;
import org.evoloop.evolution.Occurrence;
import org.evoloop.evolution.Sentry;
import org.evoloop.loop.Component;
import org.evoloop.loop.LoopConfig;
import org.evoloop.loop.LoopState;
import org.evoloop.statemachine.Event;
import org.evoloop.time.Clock;
import org.evoloop.time.Threads;
import org.jspecify.annotations.Nullable;

/**
 * The converter behind a {@link SystemEventConverter}: puts its parts together, and changes them one change at a time.
 *
 * <p>Threading: as {@link SystemEventConverter}.
 */
final class Converter implements ConverterDelegate {
    private final LoopConfig config;
    private final Ownership ownership;
    private final Spares spares = new Spares();
    private final FailureLog failures;
    private final Listeners listeners;
    private final ChangeLock changes;
    private final Stopping stopping;
    private final Evolver evolver;
    private final ComponentChanges components;
    private @Nullable StateKnowledge knowledge;
    private volatile @Nullable Function<ModelPair, ? extends StateKnowledge> knowledgeFactory;
    private volatile @Nullable DeviceLink link;
    private @Nullable ConverterJournal journal;
    private Sentry.@Nullable Posting posting;
    private volatile @Nullable ConverterShell shell;

    /** When the loop was last closed, or built. */
    private volatile Instant closedAt = Instant.EPOCH;

    Converter(LoopConfig config) {
        this.config = requireNonNull(config, "the converter's config is null");
        this.ownership = new Ownership(config.name());
        this.failures = new FailureLog(config);
        this.listeners = new Listeners(config, failures);
        failures.tell(listeners::failed);
        this.changes = new ChangeLock(config.name(), this::isComponent, this::ownsCurrentThread, listeners::deliver);
        this.stopping = new Stopping(config.name());
        this.components = new ComponentChanges(ownership);
        this.evolver = new Evolver(config, changes, ownership, components::present);
    }

    @Override
    public void addKnowledge(StateKnowledge stateKnowledge) {
        requireNonNull(stateKnowledge, "the knowledge is null");
        changes.change(() -> {
            if (knowledge != null) {
                throw new IllegalStateException("there is knowledge already, " + knowledge.name());
            }
            knowledge = stateKnowledge;
        });
    }

    @Override
    public void addKnowledgeFactory(Function<ModelPair, ? extends StateKnowledge> factory) {
        requireNonNull(factory, "the knowledge factory is null");
        changes.change(() -> knowledgeFactory = factory);
    }

    @Override
    public StateKnowledge knowledgeOf(ModelPair models) {
        return Construction.knowledgeOf(requireNonNull(models, "the models are null"), knowledgeFactory);
    }

    @Override
    public void addListener(ConverterListener listener) {
        listeners.add(requireNonNull(listener, "the listener is null"));
    }

    @Override
    public void removeListener(ConverterListener listener) {
        listeners.remove(listener);
    }

    @Override
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

    @Override
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

    @Override
    public void addLink(DeviceLink deviceLink) {
        link = requireNonNull(deviceLink, "the link is null");
    }

    @Override
    public void addSpare(String name, Supplier<? extends Component> spare) {
        spares.add(name, spare);
    }

    @Override
    public void add(Component component) {
        requireNonNull(component, "the component is null");
        changes.change(() -> components.add(shell, component));
    }

    @Override
    public void build() {
        changes.change(this::buildInTurn);
    }

    private void buildInTurn() {
        StateKnowledge known = knowledge;
        if (shell != null) {
            throw new IllegalStateException("converter " + config.name() + " has been built before");
        }
        if (changes.isClosing()) {
            throw new IllegalStateException("converter " + config.name() + " has been closed");
        }
        Construction construction = new Construction(config, ownership, components.present());
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
            ownership.giveBackAll(null);
            closeJournal();
            throw refused;
        }
    }

    @Override
    public void start() {
        ConverterShell built = built();
        stopping.await(ownsCurrentThread());
        changes.change(() -> {
            if (built.loop().state() == LoopState.EXITED) {
                // Its components may belong to another converter by now.
                throw new IllegalStateException("the loop " + config.name() + " has ended");
            }
            if (built.loop().state() != LoopState.RUNNING) {
                built.start();
            }
        });
    }

    @Override
    public boolean stop() {
        ConverterShell built = built();
        if (!built.holdsDevice()) {
            return true;
        }
        built.loop().shut();
        Runnable rest = () -> changes.change(() -> {
            // In case it was just being opened.
            built.loop().shut();
            release(built);
        });
        if (!config.threads()) {
            rest.run();
            return true;
        }
        return stopping.begin(rest, ownsCurrentThread());
    }

    /** Called after the loop was closed. */
    private void release(ConverterShell built) {
        if (built.holdsDevice()) {
            built.loop().awaitQuiet();
            closedAt = config.clock().wallTime();
            built.release();
        }
    }

    /** Whether the caller is a component, a function or the clock. Code called by one of these must not wait for it. */
    private boolean ownsCurrentThread() {
        ConverterShell built = shell;
        return listeners.ownsCurrentThread() || (built != null && built.ownsCurrentThread());
    }

    /** Whether the caller must not even wait for its turn to change the converter: every change waits for it. */
    private boolean isComponent() {
        ConverterShell built = shell;
        return built != null && (built.loop().ownsCurrentThread() || built.callsHook());
    }

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
                built.loop().close();
                release(built);
                ownership.giveBackAll(built.knowledge());
            }
            closeJournal();
        });
        listeners.close();
        stopping.await(false);
    }

    @Override
    public void remove(String name) {
        ConverterShell built = built();
        changes.change(() -> components.remove(built, name));
    }

    @Override
    public void exchange(String name, Component next) {
        ConverterShell built = built();
        requireNonNull(next, "what shall take the place of " + name + " is null");
        changes.change(() -> components.exchange(built, name, next));
    }

    @Override
    public void exchange(String name, String spare) {
        exchange(name, spares.make(spare));
    }

    @Override
    public Set<String> spares() {
        return spares.names();
    }

    @Override
    public Set<String> spares(Component.Role role) {
        return spares.of(role);
    }

    @Override
    public Evolution.Result evolve(Evolution evolution) {
        return evolver.evolve(built(), requireNonNull(evolution, "the evolution is null"));
    }

    @Override
    public Evolution.Result rollBack(Duration deadline) {
        return evolver.rollBack(built(), deadline, "as its owner asked for");
    }

    @Override
    public Shadow shadow(Evolution evolution) {
        return evolver.shadow(built(), requireNonNull(evolution, "the evolution is null"));
    }

    @Override
    public Optional<Shadow> shadow() {
        return Optional.ofNullable(evolver.shadow());
    }

    @Override
    public boolean offer(Occurrence occurrence) {
        boolean taken = built().loop().offer(occurrence);
        listeners.deliver();
        return taken;
    }

    @Override
    public void observe(EventMonitor monitor) throws InterruptedException {
        built().loop().observe(monitor);
        listeners.deliver();
    }

    @Override
    public boolean step() {
        boolean stepped = built().loop().step();
        listeners.deliver();
        evolver.stepped();
        return stepped;
    }

    @Override
    public Clock clock() {
        return config.clock();
    }

    @Override
    public boolean hasThreads() {
        return config.threads();
    }

    @Override
    public StateKnowledge knowledge() {
        return built().knowledge();
    }

    @Override
    public Set<Event> sendableEvents() {
        return built().sendable();
    }

    @Override
    public Set<Event> controllerEvents() {
        return built().controllerEvents();
    }

    @Override
    public Prospect prospect() {
        return built().prospect();
    }

    @Override
    public ConverterStatus status() {
        return built().status(evolver.describe(knowledge()), link, closedAt);
    }

    @Override
    public List<HistoryEntry> history() {
        return built().driver().history();
    }

    @Override
    public List<HistoryEntry> history(int count) {
        if (count < 1 || count > SystemEventConverter.MOST_HISTORY) {
            throw new IllegalArgumentException(
                    "history shows 1 to " + SystemEventConverter.MOST_HISTORY + " events, not " + count);
        }
        return built().driver().history(count);
    }

    private ConverterShell built() {
        ConverterShell built = shell;
        if (built == null) {
            throw new IllegalStateException("converter " + config.name() + " is not built yet");
        }
        return built;
    }
}
