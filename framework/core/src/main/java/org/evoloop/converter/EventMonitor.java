package org.evoloop.converter;

import static java.util.Objects.requireNonNull;

import java.util.Collections;
import java.util.HashSet;
import java.util.Set;
import java.util.function.BiFunction;
import java.util.function.Predicate;
import org.evoloop.converter.attachment.Endings;
import org.evoloop.converter.attachment.EventsByName;
import org.evoloop.converter.attachment.Friends;
import org.evoloop.converter.attachment.MonitorAccess;
import org.evoloop.evolution.DeviceEvents;
import org.evoloop.evolution.EventNames;
import org.evoloop.evolution.Occurrence;
import org.evoloop.evolution.Source;
import org.evoloop.evolution.Values;
import org.evoloop.loop.Intake.Admission;
import org.evoloop.loop.LoopConfig;
import org.evoloop.loop.LoopState;
import org.evoloop.loop.MapeLoop;
import org.evoloop.loop.Monitor;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.State;
import org.evoloop.time.Clock;
import org.jspecify.annotations.Nullable;

/**
 * Superclass of monitors of a converter: {@link #getEvent} waits for an event of the controller or the device and
 * returns it, made by one of the methods {@code from...}.
 *
 * <p>Threading: as {@link Monitor}; the methods {@code from...} may be called from any thread.
 *
 * @since 0.1
 */
public abstract class EventMonitor extends Monitor<Occurrence> {
    /** Of an event made before this monitor was part of a converter, which has the code of the guards. */
    private static final Set<String> NOT_EVALUATED = Collections.unmodifiableSet(new HashSet<>());

    static {
        Friends.MONITOR.give(monitor -> ((EventMonitor) monitor).new Access());
    }

    private volatile @Nullable EventNames eventNames;
    private volatile @Nullable LoopConfig config;
    private volatile @Nullable MapeLoop<Occurrence, ?, ?> loop;
    private volatile BiFunction<Event, Values, Set<String>> guards = (event, values) -> NOT_EVALUATED;
    private volatile Predicate<Event> devicesOwn = event -> false;
    private volatile @Nullable Endings endings;

    /** A monitor named after its class. */
    protected EventMonitor() {}

    /** @param name its name in the console, unique within a converter */
    protected EventMonitor(String name) {
        super(name);
    }

    private final class Access implements MonitorAccess {
        @Override
        public void attach(
                LoopConfig loopConfig,
                MapeLoop<Occurrence, ?, ?> joined,
                EventNames names,
                BiFunction<Event, Values, Set<String>> holding,
                Predicate<Event> own,
                Endings ends) {
            devicesOwn = own;
            endings = ends;
            eventNames = names;
            config = loopConfig;
            loop = joined;
            guards = holding;
            attached(names, loopConfig.clock());
        }

        @Override
        public void useNames(EventNames names) {
            eventNames = names;
        }

        @Override
        public void requireKnown(EventNames names) {
            EventMonitor.this.requireKnown(names);
        }

        @Override
        public Set<Event> spontaneousEvents() {
            return EventsByName.of(name() + ".spontaneousEvents()", EventMonitor.this.spontaneousEvents());
        }

        @Override
        public Set<Event> controllerEvents() {
            return EventsByName.of(name() + ".controllerEvents()", EventMonitor.this.controllerEvents());
        }
    }

    /** @throws IllegalArgumentException if it reports an event that is not among {@code names} */
    void requireKnown(EventNames names) {}

    /** Called when it becomes part of a converter with this clock. */
    void attached(EventNames names, Clock clock) {}

    /** Whether its converter has been closed, or continues without it. */
    final boolean isDetached() {
        MapeLoop<Occurrence, ?, ?> joined = loop;
        return joined != null && (joined.state() == LoopState.EXITED || !joined.has(this));
    }

    /** Reports to the loop on the caller's thread; null if {@link #getEvent} has to, on the monitor's thread. */
    final @Nullable Admission report(Occurrence occurrence) {
        MapeLoop<Occurrence, ?, ?> joined = loop;
        return joined == null ? null : joined.report(this, occurrence);
    }

    /** Whether a thread of the converter serves this monitor now, and the loop does not wait for the caller. */
    final boolean isServed() {
        MapeLoop<Occurrence, ?, ?> joined = loop;
        return joined != null
                && hasThread()
                && joined.state() != LoopState.NEW
                && joined.state() != LoopState.EXITED
                && joined.has(this)
                && !joined.ownsCurrentThread();
    }

    /** Whether it has been removed from a converter that was built. */
    final boolean hasLeft() {
        MapeLoop<Occurrence, ?, ?> joined = loop;
        return joined != null && joined.state() != LoopState.NEW && !joined.has(this);
    }

    /** Whether it is part of a converter that has been built, and not closed. */
    final boolean isBuilt() {
        MapeLoop<Occurrence, ?, ?> joined = loop;
        return joined != null && joined.state() != LoopState.NEW && joined.has(this);
    }

    /**
     * Refuses {@code pressed} if it can never be taken.
     *
     * @throws IllegalArgumentException if neither model knows the event, or only the device can raise it
     * @throws IllegalStateException if this monitor is not part of a converter
     */
    final void requirePressable(Occurrence pressed) {
        MapeLoop<Occurrence, ?, ?> joined = loop;
        LoopConfig attached = config;
        EventNames names = eventNames;
        if (joined == null || attached == null || names == null || !joined.has(this)) {
            throw notPart(pressed);
        }
        if (pressed instanceof Occurrence.Heard heard) {
            names.require(heard.event());
            if (devicesOwn.test(heard.event())) {
                throw new IllegalArgumentException(DeviceEvents.notPressed(heard.event()));
            }
        }
    }

    /** Who tells how {@code pressed} ends. */
    final Endings endings(Occurrence pressed) {
        Endings told = endings;
        if (told == null) {
            throw notPart(pressed);
        }
        return told;
    }

    /** Says that {@code pressed} is lost because there is no converter. */
    final IllegalStateException notPart(Occurrence pressed) {
        return new IllegalStateException(
                name() + " is not part of a converter that was built, so " + pressed.label() + " is refused");
    }

    /** The loop's answer to {@code pressed} if it is given at once, whatever was reported before; null if it is not. */
    final @Nullable Admission answerAtOnce(Occurrence pressed) {
        MapeLoop<Occurrence, ?, ?> joined = loop;
        return joined == null || joined.state() != LoopState.NEW ? null : joined.admit(pressed);
    }

    /**
     * Why the loop has not taken an event; empty if it has.
     *
     * @param so what that means for the event, such as {@code ", so up is lost"}
     */
    final String whyNotTaken(Admission admission, String so) {
        String why = switch (admission) {
            case TAKEN -> "";
            case FIRST_DROPPED, DROPPED ->
                " has a full queue" + so + "; try again when it has handled the events that wait";
            case NOT_RECORDED -> " cannot write its journal" + so + "; make room on its disk";
            case REFUSED -> isDetached() ? " is closed" + so : " is stopped" + so + "; start it first";
        };
        return why.isEmpty() ? "" : converter() + why;
    }

    private String converter() {
        LoopConfig attached = config;
        return "the converter " + (attached == null ? name() : attached.name());
    }

    /** Whether this monitor has a thread of its own; without, {@link #getEvent} must not wait. */
    protected final boolean hasThread() {
        LoopConfig attached = config;
        return attached == null || attached.threads();
    }

    /**
     * Events that the device takes by itself: those that only the device can raise, such as that it has finished, and
     * those that can also be sent, such as those of its own buttons. Time triggers of the original model, and events
     * that it declares to be the device's own, need not be listed.
     */
    protected Set<String> spontaneousEvents() {
        return Set.of();
    }

    /**
     * Events that a controller raises through this monitor. Only those need be listed that the new model has in new states
     * alone, where it cannot tell them from a function's; one that no model has counts for nothing.
     */
    protected Set<String> controllerEvents() {
        return Set.of();
    }

    /** A control of the controller was operated; the device does not know of it. */
    protected final Occurrence fromController(String event) {
        return fromController(event, Values.NONE);
    }

    /** As {@link #fromController(String)}, for an event with {@code values}. */
    protected final Occurrence fromController(String event, Values values) {
        return occurrence(event, values, Source.CONTROLLER, false);
    }

    /**
     * A control on the device was operated.
     *
     * @param deviceActed true if the device has acted on it by itself, false if it merely reports it
     */
    protected final Occurrence fromPanel(String event, boolean deviceActed) {
        return occurrence(event, Values.NONE, Source.PANEL, deviceActed);
    }

    /** The device did something by itself. */
    protected final Occurrence fromDevice(String event) {
        return fromDevice(event, Values.NONE);
    }

    /** As {@link #fromDevice(String)}, for an event with {@code values}. */
    protected final Occurrence fromDevice(String event, Values values) {
        return occurrence(event, values, Source.DEVICE, true);
    }

    /**
     * The device was found in {@code state} of its model, whatever the converter believed: after the connection was
     * lost, or when the device did something that its model does not describe. This has no effect if the state is
     * already known, or if the device has been sent an event since.
     */
    protected final Occurrence foundIn(String state) {
        return new Occurrence.Found(new State(state), nanoTime());
    }

    private Occurrence occurrence(String event, Values values, Source source, boolean deviceActed) {
        EventNames names = eventNames;
        Event heard = names == null ? new Event(event) : names.named(event);
        requireNonNull(values, "the values of an event are null; Values.NONE are none");
        // A fact moves the record at once, so its guards are evaluated here, before it is reported.
        Set<String> holding = guards.apply(heard, values);
        return new Occurrence.Heard(heard, values, source, deviceActed, holding, Occurrence.ANY_VISIT, nanoTime());
    }

    /** {@code early} with the guards that hold now, if it was made before this monitor was part of a converter. */
    final Occurrence evaluated(Occurrence early) {
        return early instanceof Occurrence.Heard heard && heard.holding() == NOT_EVALUATED
                ? new Occurrence.Heard(
                        heard.event(),
                        heard.values(),
                        heard.source(),
                        heard.deviceActed(),
                        guards.apply(heard.event(), heard.values()),
                        heard.visit(),
                        heard.observedNanos())
                : early;
    }

    private long nanoTime() {
        LoopConfig attached = config;
        return attached == null ? 0 : attached.clock().nanoTime();
    }
}
