package org.evoloop.converter;

import static java.util.Objects.requireNonNull;

import java.time.Duration;
import java.util.Collections;
import java.util.HashSet;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.atomic.AtomicReference;
import java.util.function.Consumer;
import java.util.function.Function;
import org.evoloop.converter.attachment.EventsByName;
import org.evoloop.converter.attachment.ExecuteAccess;
import org.evoloop.converter.attachment.Friends;
import org.evoloop.converter.attachment.UserCode;
import org.evoloop.evolution.Configuration;
import org.evoloop.evolution.Step;
import org.evoloop.evolution.Values;
import org.evoloop.loop.Execute;
import org.evoloop.loop.LoopConfig;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.State;
import org.evoloop.time.Clock;
import org.jspecify.annotations.Nullable;

/**
 * Superclass of the components that send events to the device.
 *
 * <p>Threading: all methods are called on the component's own thread, one at a time; except that {@link #settled} is
 * also called once before the loop opens, and {@link #released}, on another thread. The converter waits for these two,
 * by default 30 s for {@code settled} and 2 s for {@code released}, then interrupts them.
 *
 * @since 0.1
 */
public abstract class EventExecute extends Execute<ChangePlan> {
    static {
        Friends.EXECUTE.give(execute -> ((EventExecute) execute).access);
    }

    private final ExecuteAccess access = new Access();
    private volatile @Nullable Set<Event> events;
    private volatile Values values = Values.NONE;
    private volatile ExecuteAccess.@Nullable Host host;
    private volatile @Nullable LoopConfig config;

    /** A component named after its class. */
    protected EventExecute() {}

    /** @param name its name in the console, unique within a converter */
    protected EventExecute(String name) {
        super(name);
    }

    /** How a component made by {@link #of} sends. */
    @FunctionalInterface
    public interface Sending {
        /**
         * Sends the event of {@code step}, see {@link EventExecute#send}.
         *
         * @throws Exception any failure: the event had no effect
         */
        void send(Step step) throws Exception;
    }

    /**
     * A component that only sends.
     *
     * @param name its name in the console, unique within a converter
     * @param events that it can send, see {@link #sendableEvents}
     */
    public static EventExecute of(String name, Set<String> events, Sending sending) {
        Set<String> sendable = Set.copyOf(events);
        requireNonNull(sending, "how " + name + " sends is null");
        return new EventExecute(name) {
            @Override
            protected Set<String> sendableEvents() {
                return sendable;
            }

            @Override
            protected void send(Step step) throws Exception {
                sending.send(step);
            }
        };
    }

    /**
     * The events that {@link #send} can send; plans consist only of these. Called when the converter is built; the
     * result must not change. Events that the device raises by itself do not belong here.
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
     * Sends the event of {@code step} to the device, which is in the step's source state. When this returns, the event
     * is taken to have had its effect, and the original model moves to the step's target.
     *
     * @throws InterruptedException if the thread is interrupted while it waits
     * @throws UnknownEffectException if it is unknown whether the event had its effect: the device is asked, see {@link
     *     #locate}
     * @throws Exception any other failure: it had none; the original model stays where it is, and the rest of the plan
     *     is not carried out
     */
    protected abstract void send(Step step) throws Exception;

    /**
     * Reports that the step being sent has had its effect. This is for adapters that read from the device when that
     * happens, and report on the same thread what the device does by itself. Then everything reaches the converter in
     * the order in which it happened at the device, and the record is never in doubt. Without this call, an effect
     * counts as reported when {@code send} returns. May be called from any thread; does nothing when nothing is being
     * sent.
     */
    protected final void tookEffect() {
        report(true);
    }

    /**
     * Sends the event of {@code step} for another component, which finds out by itself when that has had its effect, such
     * as by a meter. This component is not added to a converter then, and what it says of effects counts for nothing.
     *
     * @param other the component that was added, and that is carrying out the step
     * @throws Exception as {@link #awaitReady} and {@link #send}
     */
    public final void sendFor(EventExecute other, Step step) throws Exception {
        config = other.config;
        values = other.values;
        awaitReady(step);
        send(step);
    }

    /** The events that {@link #sendFor} can send. */
    public final Set<String> sendsFor() {
        return sendableEvents();
    }

    private void report(boolean inOrder) {
        ExecuteAccess.Host attached = host;
        if (attached != null) {
            attached.tookEffect(access, inOrder);
        }
    }

    /** The values of the event that is being converted; for {@link #awaitReady} and {@link #send}. */
    protected final Values values() {
        return values;
    }

    /**
     * The converter's clock.
     *
     * @throws IllegalStateException if this component is not part of a converter yet
     */
    protected final Clock clock() {
        return config().clock();
    }

    /**
     * Waits for {@code duration} of the converter's time, such as until the device is ready for the next event. Without
     * threads it returns at once: who takes the steps moves the clock.
     *
     * @throws InterruptedException if the thread is interrupted first
     * @throws IllegalStateException as {@link #clock}
     */
    protected final void sleep(Duration duration) throws InterruptedException {
        if (config().threads()) {
            clock().sleep(duration);
        }
    }

    private LoopConfig config() {
        LoopConfig attached = config;
        if (attached == null) {
            throw new IllegalStateException(name() + " is not part of a converter yet, so it has no clock");
        }
        return attached;
    }

    /**
     * Asks the device for its state after the record came into doubt: a component was given up while sending, or does
     * not know whether the event it sent had its effect ({@link UnknownEffectException}), or the device acted by itself
     * while a step was on its way. Events wait meanwhile, up to the loop's step limit.
     *
     * <p>The answer must be newer than everything that was reported before. A step that was given up is expected to
     * have had its effect by then, or never to have it. If its component reports the effect later, it counts as having
     * come after the answer if its order is known; else the record is in doubt again.
     *
     * @return the name of a state of the original model; empty, the default, if the device does not know it: then the
     *     converter continues with the most likely state, and reports the doubt. It assumes that a step that was given
     *     up had no effect, and that the device's own actions happened in the order in which they were reported
     * @throws Exception any failure: it is reported, and the next component is asked; after the last one the record
     *     stays in doubt. So it does after a name that the original model does not have
     */
    protected Optional<String> locate() throws Exception {
        return Optional.empty();
    }

    /**
     * An event has been handled, and the system is in the states {@code now}; the new function has not started yet. Set
     * up here what the device needs in each state, such as a mode. Called for every execute component that does not
     * hang, one after another, whichever has sent something.
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

    @Override
    protected final void execute(ChangePlan plan) throws Exception {
        ExecuteAccess.Host attached = host;
        if (attached != null) {
            attached.carryOut(plan.occurrence(), plan.decision(), access);
        }
    }

    private final class Access extends ExecuteAccess {
        @Override
        public String name() {
            return EventExecute.this.name();
        }

        @Override
        public void attach(ExecuteAccess.Host joined, LoopConfig loopConfig) {
            config = loopConfig;
            host = joined;
        }

        /** Called only once by the component: every converted event needs them more than once. */
        @Override
        public Set<Event> events() {
            Set<Event> known = events;
            if (known == null) {
                known = Collections.unmodifiableSet(
                        new HashSet<>(EventsByName.of(name() + ".sendableEvents()", sendableEvents())));
                events = known;
            }
            return known;
        }

        @Override
        public void carry(Values carried) {
            values = carried;
        }

        @Override
        public void awaitReady(Step step) throws Exception {
            EventExecute.this.awaitReady(step);
        }

        @Override
        public void send(Step step) throws Exception {
            EventExecute.this.send(step);
        }

        @Override
        public void sendReturned() {
            report(false);
        }

        @Override
        public Optional<State> locate(Function<String, State> states, boolean isLast, Consumer<Throwable> reports)
                throws Exception {
            AtomicReference<Optional<State>> found = new AtomicReference<>(Optional.empty());
            UserCode.Call asking = () -> found.set(requireNonNull(
                            EventExecute.this.locate(),
                            "locate() is null; return Optional.empty() if the device does not know it")
                    .map(states));
            if (isLast) {
                asking.run();
            } else {
                Throwable cause = UserCode.call(asking);
                if (cause != null) {
                    reports.accept(cause);
                }
            }
            return requireNonNull(found.get());
        }

        @Override
        public void settled(Configuration now) throws Exception {
            EventExecute.this.settled(now);
        }

        @Override
        public void released() throws Exception {
            EventExecute.this.released();
        }
    }
}
