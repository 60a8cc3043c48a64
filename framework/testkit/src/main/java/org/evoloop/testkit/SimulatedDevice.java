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
import org.evoloop.evolution.DeviceEvents;
import org.evoloop.evolution.Step;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.StateMachine;
import org.evoloop.time.Clock;
import org.evoloop.time.ManualClock;
import org.jspecify.annotations.Nullable;

/**
 * A device that does what an original model says, with its adapter to the converter: it obeys the events that it is
 * sent, has buttons of its own, takes its time, and meets with what devices meet with.
 *
 * <pre>{@code
 * SimulatedDevice robot = SimulatedDevice.of(models.original()).buttons("Clean").build();
 * ConverterHarness converter = ConverterHarness.of(new RobotKnowledge(models)).with(robot).start();
 * robot.incidents(IncidentPlan.at(2, Incident.lost()));
 * }</pre>
 *
 * <p>Its adapter keeps the order: facts and effects reach the converter as they happened at the device. An event that
 * means nothing where the device is changes nothing. Its time triggers, and effects as drawn, are its own; the
 * converter knows those times from the model, so that nothing is told of them.
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
    private final boolean tellsEffects;
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
        tellsEffects = builder.tellsEffects;
        answersLocate = builder.answersLocate;
    }

    /** Begins a device of this model. */
    public static Builder of(StateMachine original) {
        return new Builder(requireNonNull(original, "the device's model is null"));
    }

    /** What a device is like. */
    public static final class Builder {
        private final StateMachine model;
        private final Set<String> sendable = new LinkedHashSet<>();
        private final Set<String> buttons = new LinkedHashSet<>();
        private Predicate<String> guards = guard -> false;
        private Duration effectDelay = Duration.ZERO;
        private Duration recovery = Duration.ZERO;
        private boolean tellsEffects = true;
        private boolean answersLocate;

        private Builder(StateMachine model) {
            this.model = model;
        }

        private Set<String> sendableByModel() {
            Set<Event> own =
                    new DeviceEvents(Set.of(), Set.of()).declaredBy(model).spontaneous();
            return model.triggers().stream()
                    .filter(trigger -> !own.contains(trigger))
                    .map(Event::name)
                    .collect(Collectors.toSet());
        }

        /**
         * Which events can be sent; all but those that the model declares to be the device's own, unless this is
         * called.
         */
        public Builder sends(String... events) {
            sendable.addAll(List.of(events));
            return this;
        }

        /**
         * Events that the device takes by itself, by buttons of its own and otherwise, besides those its model
         * declares.
         */
        public Builder buttons(String... events) {
            buttons.addAll(List.of(events));
            return this;
        }

        /** Tells which guards of the model hold, by their text; none unless this is called. */
        public Builder guards(Predicate<String> holds) {
            guards = requireNonNull(holds, "the guards' condition is null");
            return this;
        }

        /** How long a command is on its way before it has its effect; no time unless this is called. */
        public Builder takesEffectAfter(Duration delay) {
            effectDelay = Clock.requireDelay(delay);
            return this;
        }

        /** How long after an effect the device is ready for the next command; at once unless this is called. */
        public Builder readyAfter(Duration delay) {
            recovery = Clock.requireDelay(delay);
            return this;
        }

        /** Does not tell when a command has its effect: that counts when it was sent, and a lost one goes unnoticed. */
        public Builder silent() {
            tellsEffects = false;
            return this;
        }

        /** Tells where it is when the converter asks, see {@link EventExecute#locate}; otherwise it cannot. */
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
     * @param its the converter's clock, in whose time it lives
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

    /** From the next command on, these befall them; {@link #commands} tells which number that has. */
    public synchronized void incidents(IncidentPlan plan) {
        incidents = requireNonNull(plan, "the plan is null");
    }

    /** Where it truly is. */
    public String state() {
        return model.state().name();
    }

    /** The commands that have arrived, in order, also those that meant nothing where it was. */
    public synchronized List<String> received() {
        return List.copyOf(received);
    }

    /** How many commands have been on their way, lost ones included. */
    public synchronized int commands() {
        return commands;
    }

    /** The effects that it has carried out, as drawn, in order. */
    public List<String> effects() {
        return model.effects();
    }

    /**
     * It does {@code event} of its own accord, and tells.
     *
     * @throws IllegalStateException if it does not know the event where it is
     */
    public synchronized void acts(String event) {
        if (!model.take(event)) {
            throw new IllegalStateException("the device, in " + state() + ", does not know " + event);
        }
        monitor.acted(event);
    }

    /** A button of its own is pressed: it acts on it and tells, or ignores it where it means nothing; false then. */
    public synchronized boolean button(String event) {
        boolean taken = model.take(event);
        if (taken) {
            monitor.pressed(event);
        }
        return taken;
    }

    /** It does {@code event} of its own accord after {@code delay}, if it knows it where it is then. */
    public synchronized void actsAfter(Duration delay, String event) {
        requireJoined(clock).schedule(delay, () -> {
            synchronized (this) {
                if (model.take(event)) {
                    monitor.acted(event);
                }
            }
        });
    }

    /** Somebody has put it into {@code state}, and nobody was told. */
    public void put(String state) {
        model.put(state);
    }

    /** It is found where it is. */
    public synchronized void tellsState() {
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
            boolean lost = befalling.contains(Incident.lost());
            if (befalling.contains(Incident.refused()) || (lost && tellsEffects)) {
                throw new IOException("the device " + (lost ? "does not answer " : "refuses ") + event);
            }
            if (!lost) {
                take(event, befalling, tookEffect);
            }
        }
    }

    private void take(String event, List<Incident> befalling, Runnable tookEffect) throws IOException {
        received.add(event);
        model.take(event);
        readyAtNanos = requireJoined(clock).nanoTime() + recovery.toNanos();
        boolean answers = !befalling.contains(Incident.unanswered());
        if (tellsEffects && answers) {
            tookEffect.run();
        }
        for (Incident incident : befalling) {
            if (incident instanceof Incident.After after && model.knows(after.event())) {
                acts(after.event());
            }
        }
        if (!answers) {
            throw new IOException("the device has taken " + event + ", and its answer was lost");
        }
    }

    /** Lets time pass for whoever sends: without threads nobody else would. */
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

    /** For messages: where it is, and what befalls its commands if that is by chance. */
    @Override
    public synchronized String toString() {
        String plan = incidents.toString();
        return state() + ", received " + received + (plan.contains("seed") ? ", " + plan : "");
    }

    /** Tells what the device does by itself. */
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
            tell(() -> push(fromDevice(event)));
        }

        void pressed(String event) {
            tell(() -> push(fromPanel(event, true)));
        }

        void found(String state) {
            tell(() -> push(foundIn(state)));
        }

        /** At once, so that nothing overtakes it: without threads a monitor has to be asked. */
        private void tell(Runnable push) {
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

    /** Sends what the device can be sent. */
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
