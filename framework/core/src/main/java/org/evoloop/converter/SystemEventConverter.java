package org.evoloop.converter;

import java.time.Duration;
import java.util.List;
import java.util.Optional;
import java.util.ServiceLoader;
import java.util.Set;
import java.util.function.Function;
import java.util.function.Supplier;
import org.evoloop.evolution.ModelPair;
import org.evoloop.evolution.Occurrence;
import org.evoloop.evolution.Sentry;
import org.evoloop.loop.Component;
import org.evoloop.loop.LoopConfig;
import org.evoloop.loop.LoopState;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.ModelException;
import org.evoloop.time.Clock;

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
 * <p>Threading: all methods may be called from any thread; components cannot change the converter, but may {@link
 * #stop} and {@link #close} it, and functions, tasks of visits and listeners may change it too.
 *
 * @since 0.1
 */
public final class SystemEventConverter implements AutoCloseable {
    /** The most events that {@link #history(int)} returns at once. */
    public static final int MOST_HISTORY = 100_000;

    private static final ConverterDelegate.Maker DELEGATES = ServiceLoader.load(
                    ConverterDelegate.Maker.class, SystemEventConverter.class.getClassLoader())
            .findFirst()
            .orElseThrow(() -> new IllegalStateException("the service " + ConverterDelegate.Maker.class.getName()
                    + " is missing; whoever merges jar files keeps what is in META-INF/services"));

    private final ConverterDelegate delegate;

    /** @param config its options, checked by {@link #build} */
    public SystemEventConverter(LoopConfig config) {
        this.delegate = DELEGATES.make(config);
    }

    /**
     * Adds a monitor, also while the converter runs.
     *
     * @throws IllegalStateException if the name is taken
     */
    public void addMonitor(EventMonitor monitor) {
        delegate.add(monitor);
    }

    /** Sets the analyze component, in place of the default; before {@link #build}. */
    public void addAnalyze(EventAnalyze analyze) {
        delegate.add(analyze);
    }

    /** Sets the plan component, in place of the default; before {@link #build}. */
    public void addPlan(EventPlan plan) {
        delegate.add(plan);
    }

    /**
     * Adds an execute component, also while the converter runs.
     *
     * @throws IllegalStateException if the name is taken
     * @throws ModelException if it sends an event that the device does not have
     */
    public void addExecute(EventExecute execute) {
        delegate.add(execute);
    }

    /**
     * Sets the knowledge, before {@link #build}.
     *
     * @throws IllegalStateException if there is one already
     */
    public void addKnowledge(StateKnowledge stateKnowledge) {
        delegate.addKnowledge(stateKnowledge);
    }

    /**
     * Sets how knowledge of other models is made, before {@link #build}. Such models are those to which the converter
     * had evolved when the previous process ended, and those passed to {@link #knowledgeOf}.
     */
    public void addKnowledgeFactory(Function<ModelPair, ? extends StateKnowledge> factory) {
        delegate.addKnowledgeFactory(factory);
    }

    /**
     * Makes knowledge of other models, for {@link #evolve}.
     *
     * @throws IllegalStateException if there is no factory, see {@link #addKnowledgeFactory}
     * @throws ModelException if the models are no evolution
     */
    public StateKnowledge knowledgeOf(ModelPair models) {
        return delegate.knowledgeOf(models);
    }

    /** Notifies {@code listener} of what this converter does from now on. */
    public void addListener(ConverterListener listener) {
        delegate.addListener(listener);
    }

    /** Stops notifying {@code listener}; a call in progress still completes. Does nothing if it was not added. */
    public void removeListener(ConverterListener listener) {
        delegate.removeListener(listener);
    }

    /**
     * Records this converter's inputs; call it before {@link #build}, which then continues where the previous process
     * ended. Events that waited still wait, and the one in progress continues after the steps that were sent, as soon
     * as the converter is started. A step that may or may not have been sent is not sent again: the record is in doubt,
     * see {@link EventExecute#locate}.
     *
     * @throws IllegalStateException if it has been built, or has a journal already
     */
    public void journal(ConverterJournal kept) {
        delegate.journal(kept);
    }

    /**
     * Has a sentry watch this converter from each start, and from each takeover by other models. A violation is
     * recorded in the history as a failed event.
     *
     * @throws IllegalStateException if it has been built, or has a sentry already
     */
    public void watch(Sentry.Posting sentries) {
        delegate.watch(sentries);
    }

    /** Registers the connection to the device, for {@link #status}. */
    public void addLink(DeviceLink deviceLink) {
        delegate.addLink(deviceLink);
    }

    /**
     * Adds the components of a device, also while the converter runs.
     *
     * @throws IllegalStateException if a name is taken
     * @throws ModelException as {@link #addExecute}
     */
    public void addDevice(DeviceParts device) {
        addMonitor(device.monitor());
        addExecute(device.execute());
    }

    /**
     * This converter as the device of another one, whose original model is this one's new model. The other one sends the
     * controller's events of this one; each counts as carried out once this one has handled it. Where this one goes by
     * itself, the other one hears of as a state in which its device was found. This one is started and closed by its
     * owner; close the other one first. If it has no threads, the other one takes its steps.
     *
     * @throws IllegalStateException if it is not built yet
     */
    public DeviceParts asDevice() {
        LowerConverter lower = new LowerConverter(delegate);
        return new DeviceParts(lower.reports(), lower);
    }

    /**
     * Registers a spare for {@link #exchange(String, String)}.
     *
     * @throws IllegalStateException if the name is taken
     */
    public void addSpare(String name, Supplier<? extends Component> spare) {
        delegate.addSpare(name, spare);
    }

    /**
     * Checks everything, compiles the decisions of all reachable configurations, and gives every component its thread.
     *
     * @throws ModelException if models and components do not fit; the message lists all problems
     * @throws IllegalStateException if something is missing or belongs to another converter, or it has been built
     *     already
     * @throws IllegalArgumentException if an option is out of range; the message lists all of them
     * @throws RuntimeException if the journal cannot be continued; the message says why and what to do
     */
    public void build() {
        delegate.build();
    }

    /**
     * Opens the loop; does nothing if it is open.
     *
     * @throws IllegalStateException if it is not built, or has ended
     */
    public void start() {
        delegate.start();
    }

    /**
     * Closes the loop: from now on nothing begins, and waiting events are refused. The event in the loop is completed,
     * and the running new function ends; then the execute components release the device. This method waits at most 100
     * ms for that: what takes longer finishes in the background, and what hangs is given up. Does nothing if the loop
     * is closed. When called by a component, a function, a task of a visit or a listener, it does not wait at all.
     *
     * @return whether all of that has finished
     */
    public boolean stop() {
        return delegate.stop();
    }

    /**
     * Ends the converter and its threads, see {@link org.evoloop.loop.MapeLoop#close}. Idempotent. When called by a
     * component, a function, a task of a visit or a listener, it returns at once, and the converter ends after its
     * caller has returned.
     */
    @Override
    public void close() {
        delegate.close();
    }

    /**
     * Removes a component.
     *
     * @throws IllegalArgumentException if there is no component of that name
     * @throws IllegalStateException if the converter needs it
     * @throws ModelException if a decision could then not be carried out
     */
    public void remove(String name) {
        delegate.remove(name);
    }

    /**
     * Replaces the component {@code name} by {@code next}, between two events.
     *
     * @throws IllegalArgumentException if there is no component of that name, or it has another role
     * @throws ModelException if a decision could then not be carried out
     */
    public void exchange(String name, Component next) {
        delegate.exchange(name, next);
    }

    /**
     * Replaces the component {@code name} by a spare, between two events.
     *
     * @param spare its name, as given to {@link #addSpare}
     * @throws IllegalArgumentException if there is no such component or spare, or their roles differ
     */
    public void exchange(String name, String spare) {
        delegate.exchange(name, spare);
    }

    /** The names of the spares, in the order in which they were added. */
    public Set<String> spares() {
        return delegate.spares();
    }

    /**
     * The spares that can take the place of a component with this role. To know its role, a spare is made, and kept until
     * it is used; one that cannot be made is left out.
     */
    public Set<String> spares(Component.Role role) {
        return delegate.spares(role);
    }

    /**
     * Replaces the present models by others, together with their knowledge, between two events: no event is lost, none
     * is handled twice, and timers keep their remaining time. Waits until that is possible; in a converter without
     * threads it must be possible at once. Until another change, {@link #rollBack} leads back.
     *
     * @return the result for the current states
     * @throws ModelException if the models are no evolution, do not fit the components, or cannot take over in the
     *     system's present states; or if there would be no way back, and the evolution requires one
     * @throws EvolutionException if it was not possible in time, or if it never will be, since no event leads to states in
     *     which it is; the message says what prevented it, and nothing has changed
     * @throws IllegalStateException if the converter has ended, or {@code next} belongs to another converter
     */
    public Evolution.Result evolve(Evolution evolution) {
        return delegate.evolve(evolution);
    }

    /** As {@link #rollBack(Duration)}, within {@link Evolution#USUAL_DEADLINE}. */
    public Evolution.Result rollBack() {
        return rollBack(Evolution.USUAL_DEADLINE);
    }

    /**
     * Restores the models before the last {@link #evolve}, in the same way, within {@code deadline}; after a restart,
     * those with which it was built.
     *
     * @throws IllegalStateException if there was no evolution, or it has no way back
     * @throws EvolutionException as in {@link #evolve}
     */
    public Evolution.Result rollBack(Duration deadline) {
        return delegate.rollBack(deadline);
    }

    /**
     * Gives other models the same inputs from now on, and compares their decisions. Any earlier shadow ends.
     *
     * @param evolution the one that {@link Shadow#promote} carries out
     * @throws ModelException as in {@link #evolve}
     * @throws EvolutionException if they cannot begin in the system's present states
     */
    public Shadow shadow(Evolution evolution) {
        return delegate.shadow(evolution);
    }

    /** The present shadow, if any. */
    public Optional<Shadow> shadow() {
        return delegate.shadow();
    }

    /**
     * Queues an occurrence as if a monitor had reported it; false if it was refused or dropped.
     *
     * @throws IllegalArgumentException if its time is in the future of this converter's {@link #clock}
     */
    public boolean offer(Occurrence occurrence) {
        return delegate.offer(occurrence);
    }

    /**
     * The step of a monitor in a converter without threads: calls it once and queues what it returns.
     *
     * @throws IllegalStateException if the converter has threads, which call its monitors
     * @throws IllegalArgumentException if {@code monitor} does not belong to this converter
     */
    public void observe(EventMonitor monitor) throws InterruptedException {
        delegate.observe(monitor);
    }

    /** The step of a converter without threads: converts one event that waits; false if none does. */
    public boolean step() {
        return delegate.step();
    }

    /** Its clock. */
    public Clock clock() {
        return delegate.clock();
    }

    /**
     * The converter's present knowledge.
     *
     * @throws IllegalStateException if it is not built yet
     */
    public StateKnowledge knowledge() {
        return delegate.knowledge();
    }

    /**
     * What its execute components can send to the device.
     *
     * @throws IllegalStateException if it is not built yet
     */
    public Set<Event> sendableEvents() {
        return delegate.sendableEvents();
    }

    /** What a controller may raise, sorted: no time trigger, nothing of the device, of timers or of functions alone. */
    public Set<Event> controllerEvents() {
        return delegate.controllerEvents();
    }

    /**
     * A snapshot of the status.
     *
     * @throws IllegalStateException if the converter is not built yet
     */
    public ConverterStatus status() {
        return delegate.status();
    }

    /**
     * What can happen next, and what the converter would do then. It is computed on the caller's thread; guards are not
     * asked, and a rule of an analyze component is not either.
     *
     * @throws IllegalStateException if the converter is not built yet
     */
    public Outlook outlook() {
        return delegate.outlook();
    }

    /** The last events and their outcomes, oldest first. */
    public List<HistoryEntry> history() {
        return delegate.history();
    }

    /**
     * As {@link #history()}, with earlier events read from the journal; that takes some seconds if it is large.
     *
     * @param count how many entries at most, 1 to {@value #MOST_HISTORY}
     * @throws IllegalArgumentException if {@code count} is out of range
     * @throws RuntimeException if the journal cannot be read; the message says why and what to do
     */
    public List<HistoryEntry> history(int count) {
        return delegate.history(count);
    }
}
