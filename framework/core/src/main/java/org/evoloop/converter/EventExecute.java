package org.evoloop.converter;

import java.util.Collections;
import java.util.HashSet;
import java.util.Optional;
import java.util.Set;
import org.evoloop.evolution.Configuration;
import org.evoloop.evolution.Step;
import org.evoloop.evolution.Values;
import org.evoloop.loop.Execute;
import org.evoloop.statemachine.Event;
import org.jspecify.annotations.Nullable;

/**
 * Superclass of the components that send events to the device.
 *
 * <p>Threading: all methods are called on the component's own thread, one at a time; only {@link #settled}, once
 * more before the loop opens, and {@link #released} are called on another one, which the converter waits for: 30 s by default
 * for {@code settled} and 2 s for {@code released}, then it is interrupted.
 *
 * @since 0.1
 */
public abstract class EventExecute extends Execute<ChangePlan> {
    /** The turn in which a step is being sent whose effect was not reported yet; 0 if none is. Guarded by the driver. */
    long sending;

    private volatile @Nullable Set<Event> events;
    private volatile Values values = Values.NONE;
    private volatile @Nullable EffectListener listener;
    private volatile @Nullable Carrier carrier;

    /** A component with the name of its class. */
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
     * @throws InterruptedException if the thread is interrupted while it waits
     * @throws Exception any failure: the step is not taken
     */
    protected void awaitReady(Step step) throws Exception {}

    /**
     * Sends the event of {@code step} to the device, which is in the step's source state. When this returns the event is
     * taken to have had its effect, and the original model moves to the step's target.
     *
     * @throws InterruptedException if the thread is interrupted while it waits
     * @throws UnknownEffectException if it is unknown whether it had its effect: the device is asked, see {@link #locate}
     * @throws Exception any other failure: it had none; the original model stays where it is, and the rest of the plan is not
     *     carried out
     */
    protected abstract void send(Step step) throws Exception;

    /**
     * The step that {@link #send} is about has had its effect; for adapters that read from the device when that happens, and
     * report what the device does by itself on the same thread. Then everything reaches the converter in the order in which it
     * happened at the device, and the record is never in doubt. Without this call, an effect counts as reported when {@code send}
     * returns. May be called from any thread; does nothing when nothing is being sent.
     */
    protected final void tookEffect() {
        report(true);
    }

    private void report(boolean inOrder) {
        EffectListener told = listener;
        if (told != null) {
            told.tookEffect(this, inOrder);
        }
    }

    /** What the event that is being converted carries besides its name; for {@link #awaitReady} and {@link #send}. */
    protected final Values values() {
        return values;
    }

    /**
     * Asks the device where it is, after something has left the record in doubt: a component was given up while it sent, or does
     * not know whether what it has sent had its effect ({@link UnknownEffectException}), or the device acted by itself while a
     * step was on its way. Events wait meanwhile, for as long as the loop's step limit lets this take.
     *
     * <p>The answer must be newer than everything that was reported before. A step that was given up is expected to have had its effect
     * by then, or never to have it, unless its component still reports it: in order, that counts as having come after the
     * answer; else the record is in doubt again.
     *
     * @return the name of a state of the original model; empty if the device cannot tell, which is the usual answer: then
     *     the converter goes on with the likelier of the states, and says that it is in doubt. A step that was given up is
     *     taken to have had no effect, and what the device did by itself to have come in the order in which it was reported
     * @throws Exception any failure: it is reported, and the record stays in doubt
     */
    protected Optional<String> locate() throws Exception {
        return Optional.empty();
    }

    /**
     * An event has been dealt with, and the system stands at {@code now}; a new function has not started yet. What a
     * device needs in each state, such as a mode, can be seen to here.
     *
     * @throws Exception any failure: it is reported
     */
    protected void settled(Configuration now) throws Exception {}

    /**
     * The converter has stopped and its new function has ended: the device is on its own from now on.
     *
     * @throws Exception any failure: it is reported
     */
    protected void released() throws Exception {}

    final void attach(EffectListener joined, @Nullable Carrier carriedBy) {
        listener = joined;
        carrier = carriedBy;
    }

    @Override
    protected final void execute(ChangePlan plan) throws Exception {
        Carrier attached = carrier;
        if (attached != null) {
            attached.carryOut(plan, this);
        }
    }

    /** Sends a step that was announced. */
    final void perform(Step step, Values carried) throws Exception {
        values = carried;
        send(step);
        report(false);
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
