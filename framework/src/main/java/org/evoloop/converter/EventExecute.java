package org.evoloop.converter;

import java.util.Collections;
import java.util.HashSet;
import java.util.Set;
import org.evoloop.evolution.Configuration;
import org.evoloop.evolution.Step;
import org.evoloop.loop.Execute;
import org.evoloop.statemachine.Event;
import org.jspecify.annotations.Nullable;

/**
 * Superclass of the components that send events to the device.
 *
 * <p>Threading: all methods are called on the component's own thread, one at a time; only {@link #settled} is called once
 * more by whoever starts the converter, before the loop opens, and {@link #released} by whoever stops it.
 */
public abstract class EventExecute extends Execute<Conversion> {
    private volatile @Nullable Set<Event> events;

    /** A component that is called like its class. */
    protected EventExecute() {}

    /** @param name what the console calls it, unique within a converter */
    protected EventExecute(String name) {
        super(name);
    }

    /**
     * The events that {@link #send} can send; plans consist of these only. Called when the converter is built; the answer
     * must not change. Events that the device raises by itself do not belong here.
     */
    protected abstract Set<String> sendableEvents();

    /**
     * Waits until the device can take the event of {@code step}. Events queue up meanwhile.
     *
     * @throws InterruptedException if the thread is told to stop while it waits
     * @throws Exception any failure: the step is not taken
     */
    protected void awaitReady(Step step) throws Exception {}

    /**
     * Sends the event of {@code step} to the device, which is in the step's source state. When this returns the event is
     * taken to have had its effect, and the original model moves to the step's target.
     *
     * @throws InterruptedException if the thread is told to stop while it waits
     * @throws Exception any failure: the original model stays where it is, and the rest of the plan is not carried out
     */
    protected abstract void send(Step step) throws Exception;

    /**
     * An event has been dealt with, and the system stands at {@code now}; a new function has not started yet. What a
     * device needs in each state, such as a mode, can be seen to here.
     *
     * @throws Exception any failure: it is reported
     */
    protected void settled(Configuration now) throws Exception {}

    /**
     * The converter has stopped and its new function has ended: the device is on its own from now on. Called by whoever
     * stops or closes the converter.
     *
     * @throws Exception any failure: it is reported
     */
    protected void released() throws Exception {}

    @Override
    protected final void execute(Conversion conversion) throws Exception {
        conversion.performWith(this);
    }

    /** {@link #sendableEvents}, asked for once: every event that is converted needs them more than once. */
    final Set<Event> events() {
        Set<Event> known = events;
        if (known == null) {
            known = Collections.unmodifiableSet(
                    new HashSet<>(Assembly.named(name() + ".sendableEvents()", sendableEvents())));
            events = known;
        }
        return known;
    }
}
