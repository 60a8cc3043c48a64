package org.evoloop.testkit;

import static java.util.Objects.requireNonNull;

import java.io.IOException;
import java.time.Duration;
import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.function.Predicate;
import java.util.stream.Collectors;
import org.evoloop.converter.EventExecute;
import org.evoloop.converter.PushMonitor;
import org.evoloop.converter.SystemEventConverter;
import org.evoloop.converter.UnknownEffectException;
import org.evoloop.evolution.DeviceEvents;
import org.evoloop.evolution.Step;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.StateMachine;
import org.evoloop.time.Clock;
import org.evoloop.time.ManualClock;
import org.jspecify.annotations.Nullable;

/**
 * A device that behaves like an original model, with its adapter to the converter: it obeys events, may have buttons of
 * its own and delays, and can suffer the incidents of real devices.
 *
 * <pre>{@code
 * SimulatedDevice robot = SimulatedDevice.of(models.original()).buttons("Clean").build();
 * ConverterHarness converter = ConverterHarness.of(new RobotKnowledge(models)).with(robot).start();
 * robot.incidents(IncidentPlan.at(2, Incident.lost()));
 * }</pre>
 *
 * <p>Its adapter keeps the order: facts and effects reach the converter as they happened at the device. An event
 * without a transition in the device's state has no effect. Its time triggers, and effects as drawn, are its own; the
 * converter knows those times from the model, so they are not reported.
 *
 * <p>Threading: thread-safe. A device belongs to one converter.
 *
 * @since 0.1
 */
public final class SimulatedDevice {
    private final DeviceModel model;
    private final Set<String> sendable;
    private final Set<String> buttons;
    private final Duration effectDelay;
    private final Duration recovery;
    private final boolean reportsEffects;
    private final boolean answersLocate;
    private final Its monitor = new Its();
    private final Sender execute = new Sender();
    private final List<String> received = new ArrayList<>();
    private IncidentPlan incidents = IncidentPlan.none();
    private int commands;
    private long readyAtNanos;
    private @Nullable Clock clock;
    private @Nullable SystemEventConverter converter;

    private SimulatedDevice(Builder builder) {
        model = new DeviceModel(builder.model);
        model.holds(builder.guards);
        buttons = Set.copyOf(builder.buttons);
        sendable = Set.copyOf(builder.sendable.isEmpty() ? builder.sendableByModel() : builder.sendable);
        effectDelay = builder.effectDelay;
        recovery = builder.recovery;
        reportsEffects = builder.reportsEffects;
        answersLocate = builder.answersLocate;
    }

    /** Begins a device of this model. */
    public static Builder of(StateMachine original) {
        return new Builder(requireNonNull(original, "the device's model is null"));
    }

    /** The properties of a device. */
    public static final class Builder {
        private final StateMachine model;
        private final Set<String> sendable = new LinkedHashSet<>();
        private final Set<String> buttons = new LinkedHashSet<>();
        private Predicate<String> guards = guard -> false;
        private Duration effectDelay = Duration.ZERO;
        private Duration recovery = Duration.ZERO;
        private boolean reportsEffects = true;
        private boolean answersLocate;

        private Builder(StateMachine model) {
            this.model = model;
        }

        private Set<String> sendableByModel() {
            return DeviceEvents.assumedOf(model).sendable().stream()
                    .map(Event::name)
                    .collect(Collectors.toSet());
        }

        /**
         * Sets the events that can be sent; by default all but those that the model declares to be the device's own.
         */
        public Builder sends(String... events) {
            sendable.addAll(List.of(events));
            return this;
        }

        /**
         * Adds events that the device takes by itself, through its buttons or otherwise, besides those that its model
         * declares.
         */
        public Builder buttons(String... events) {
            buttons.addAll(List.of(events));
            return this;
        }

        /** Sets which guards of the model hold, by their text; by default none. */
        public Builder guards(Predicate<String> holds) {
            guards = requireNonNull(holds, "the guards' condition is null");
            return this;
        }

        /** Sets how long a command takes until it has its effect; by default no time. */
        public Builder takesEffectAfter(Duration delay) {
            effectDelay = Clock.requireDelay(delay);
            return this;
        }

        /** Sets how long after an effect the device is ready for the next command; by default at once. */
        public Builder readyAfter(Duration delay) {
            recovery = Clock.requireDelay(delay);
            return this;
        }

        /**
         * Makes it not report the effects of commands: a command counts as executed when it was sent, and a lost one
         * goes unnoticed.
         */
        public Builder silent() {
            reportsEffects = false;
            return this;
        }

        /**
         * Makes it report its state when the converter asks, see {@link EventExecute#locate}; by default it does not.
         */
        public Builder answersLocate() {
            answersLocate = true;
            return this;
        }

        /** The device. */
        public SimulatedDevice build() {
            return new SimulatedDevice(this);
        }
    }

    /**
     * Adds its monitor and its execute component; {@link ConverterHarness} does that by itself.
     *
     * @param its the converter's clock, which the device uses
     * @throws IllegalStateException if it is part of a converter already
     */
    public synchronized void addTo(SystemEventConverter joined, Clock its) {
        if (clock != null) {
            throw new IllegalStateException("this device is part of a converter already; make one for each");
        }
        converter = joined;
        clock = its;
        joined.addMonitor(monitor);
        joined.addExecute(execute);
        model.start(its);
    }

    /** Sets the incidents from the next command on; {@link #commands} is the number of the last one. */
    public synchronized void incidents(IncidentPlan plan) {
        incidents = requireNonNull(plan, "the plan is null");
    }

    /** Its true state. */
    public String state() {
        return model.state().name();
    }

    /** The commands that have arrived, in order, including those without effect. */
    public synchronized List<String> received() {
        return List.copyOf(received);
    }

    /** The number of commands sent, including lost ones. */
    public synchronized int commands() {
        return commands;
    }

    /** The effects that it has run, as drawn, in order. */
    public List<String> effects() {
        return model.effects();
    }

    /**
     * Makes it do {@code event} by itself and report that.
     *
     * @throws IllegalStateException if it has no transition for the event in its state
     */
    public synchronized void acts(String event) {
        if (!model.take(event)) {
            throw new IllegalStateException("the device, in " + state() + ", does not know " + event);
        }
        monitor.acted(event);
    }

    /**
     * Presses a button of the device: it acts on it and reports that; if it has no transition, it ignores the press,
     * and this returns false.
     */
    public synchronized boolean button(String event) {
        boolean taken = model.take(event);
        if (taken) {
            monitor.pressed(event);
        }
        return taken;
    }

    /** Makes it do {@code event} by itself after {@code delay}, if it has a transition for it then. */
    public synchronized void actsAfter(Duration delay, String event) {
        requireJoined(clock).schedule(delay, () -> {
            synchronized (this) {
                if (model.take(event)) {
                    monitor.acted(event);
                }
            }
        });
    }

    /** Puts it into {@code state} without a report. */
    public void put(String state) {
        model.put(state);
    }

    /** Reports its state, as a finding. */
    public synchronized void reportsState() {
        monitor.found(state());
    }

    private static <T> T requireJoined(@Nullable T part) {
        if (part == null) {
            throw new IllegalStateException("this device is not part of a converter yet; call addTo");
        }
        return part;
    }

    private void obey(String event, Runnable tookEffect) throws Exception {
        List<Incident> befalling;
        synchronized (this) {
            commands++;
            befalling = incidents.of(commands, event);
        }
        pass(effectDelay);
        synchronized (this) {
            for (Incident incident : befalling) {
                if (incident instanceof Incident.Before before && model.knows(before.event())) {
                    acts(before.event());
                }
            }
            if (befalling.contains(Incident.refused())) {
                throw new IOException("the device refuses " + event);
            }
            boolean lost = befalling.contains(Incident.lost());
            if (lost && reportsEffects) {
                throw new UnknownEffectException("the device does not answer " + event);
            }
            if (!lost) {
                take(event, befalling, tookEffect);
            }
        }
    }

    private void take(String event, List<Incident> befalling, Runnable tookEffect) throws UnknownEffectException {
        received.add(event);
        model.take(event);
        readyAtNanos = requireJoined(clock).nanoTime() + recovery.toNanos();
        boolean answers = !befalling.contains(Incident.unanswered());
        if (reportsEffects && answers) {
            tookEffect.run();
        }
        for (Incident incident : befalling) {
            if (incident instanceof Incident.After after && model.knows(after.event())) {
                acts(after.event());
            }
        }
        if (!answers) {
            throw new UnknownEffectException("the device has taken " + event + ", and its answer was lost");
        }
    }

    /** Advances the clock for the sender: without threads nothing else would. */
    private void pass(Duration duration) throws InterruptedException {
        if (duration.isZero()) {
            return;
        }
        Clock its = requireJoined(clock);
        if (!monitor.waits() && its instanceof ManualClock manual) {
            manual.advance(duration);
        } else {
            its.sleep(duration);
        }
    }

    /** For messages: its state, and its incident plan if that is random. */
    @Override
    public synchronized String toString() {
        String plan = incidents.toString();
        return state() + ", received " + received + (plan.contains("seed") ? ", " + plan : "");
    }

    /** Reports what the device does by itself. */
    private final class Its extends PushMonitor {
        Its() {
            super("DeviceMonitor");
        }

        @Override
        protected Set<String> spontaneousEvents() {
            return buttons;
        }

        boolean waits() {
            return hasThread();
        }

        void acted(String event) {
            report(() -> push(fromDevice(event)));
        }

        void pressed(String event) {
            report(() -> push(fromPanel(event, true)));
        }

        void found(String state) {
            report(() -> push(foundIn(state)));
        }

        /** Reports at once, so that nothing overtakes it: without threads a monitor has to be called. */
        private void report(Runnable push) {
            push.run();
            if (!hasThread()) {
                try {
                    requireJoined(converter).observe(this);
                } catch (InterruptedException stop) {
                    Thread.currentThread().interrupt();
                }
            }
        }
    }

    /** Sends events to the device. */
    private final class Sender extends EventExecute {
        Sender() {
            super("DeviceExecute");
        }

        @Override
        protected Set<String> sendableEvents() {
            return sendable;
        }

        @Override
        protected void awaitReady(Step step) throws InterruptedException {
            long left;
            synchronized (SimulatedDevice.this) {
                left = readyAtNanos - requireJoined(clock).nanoTime();
            }
            pass(Duration.ofNanos(Math.max(0, left)));
        }

        @Override
        protected void send(Step step) throws Exception {
            obey(step.trigger().name(), this::tookEffect);
        }

        @Override
        protected Optional<String> locate() {
            return answersLocate ? Optional.of(state()) : Optional.empty();
        }
    }
}
