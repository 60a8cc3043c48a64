package org.evoloop.testkit;

import static java.util.Objects.requireNonNull;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.UnaryOperator;
import org.evoloop.converter.ConverterJournal;
import org.evoloop.converter.ConverterListener;
import org.evoloop.converter.ConverterStatus;
import org.evoloop.converter.EventAnalyze;
import org.evoloop.converter.EventExecute;
import org.evoloop.converter.EventMonitor;
import org.evoloop.converter.EventPlan;
import org.evoloop.converter.HistoryEntry;
import org.evoloop.converter.StateKnowledge;
import org.evoloop.converter.SystemEventConverter;
import org.evoloop.evolution.Configuration;
import org.evoloop.evolution.Occurrence;
import org.evoloop.evolution.Values;
import org.evoloop.loop.Failure;
import org.evoloop.loop.LoopConfig;
import org.evoloop.statemachine.Names;
import org.evoloop.statemachine.State;
import org.evoloop.statemachine.StateMachine;
import org.evoloop.time.ManualClock;
import org.jspecify.annotations.Nullable;

/**
 * A converter in a test: it has no threads, and its time passes only when the test advances it.
 *
 * <pre>{@code
 * ConverterHarness lamp = ConverterHarness.of(new LampKnowledge(models)).with(new LampExecute(device)).start();
 * lamp.press("switch").press("switch").until("wait");
 * lamp.advance(Duration.ofSeconds(2)).expect("off", "off");
 * }</pre>
 *
 * <p>Every method that makes something happen returns when everything that follows from it at this moment has been
 * handled. New functions run on the caller's thread and must not block, see {@link org.evoloop.function.NewFunction}.
 *
 * <p>Errors: a failed expectation is an {@link AssertionError} with the converter's states, the waiting events, the
 * events sent, and the end of the transcript.
 *
 * <p>Threading: one thread.
 *
 * @since 0.1
 */
public final class ConverterHarness implements AutoCloseable {
    /** The longest time that {@link #until(String)} lets pass. */
    public static final Duration PATIENCE = Duration.ofHours(1);

    /** More events than this at one moment count as endless. */
    private static final int MOST_EVENTS = 2_000;

    /**
     * A monitor has nothing to report after this many rounds without news: some reports, such as a finding, may not be
     * news.
     */
    private static final int QUIET_ROUNDS = 8;

    private final ManualClock clock;
    private final SystemEventConverter converter;
    private final List<EventMonitor> monitors;
    private final TestMonitor tester = new TestMonitor();
    private final TranscriptRecorder transcript = new TranscriptRecorder();
    private final List<Failure<Occurrence>> failures = new ArrayList<>();
    private final @Nullable SimulatedDevice device;

    /** How many times in a row something became due without time having passed. */
    private int atOnce;

    private ConverterHarness(Builder builder) {
        clock = builder.clock;
        device = builder.device;
        converter = new SystemEventConverter(
                builder.options.apply(LoopConfig.defaults("test", clock)).withoutThreads());
        monitors = new ArrayList<>(builder.monitors);
        monitors.add(tester);
        monitors.forEach(converter::addMonitor);
        if (builder.analyze != null) {
            converter.addAnalyze(builder.analyze);
        }
        if (builder.plan != null) {
            converter.addPlan(builder.plan);
        }
        builder.executes.forEach(converter::addExecute);
        if (device != null) {
            device.addTo(converter, clock);
        }
        converter.addKnowledge(builder.knowledge);
        if (builder.journal != null) {
            converter.journal(builder.journal);
        }
        converter.addListener(new ConverterListener() {
            @Override
            public void failed(Failure<Occurrence> failure) {
                failures.add(failure);
            }
        });
        transcript.during(() -> {
            converter.build();
            converter.start();
        });
    }

    /** A builder of a harness for a converter with this knowledge. */
    public static Builder of(StateKnowledge knowledge) {
        return new Builder(requireNonNull(knowledge, "the knowledge is null"));
    }

    /** The parts of a converter under test. */
    public static final class Builder {
        private final StateKnowledge knowledge;
        private final List<EventMonitor> monitors = new ArrayList<>();
        private final List<EventExecute> executes = new ArrayList<>();
        private @Nullable EventAnalyze analyze;
        private @Nullable EventPlan plan;
        private @Nullable SimulatedDevice device;
        private @Nullable ConverterJournal journal;
        private ManualClock clock = new ManualClock();
        private UnaryOperator<LoopConfig> options = config -> config;

        private Builder(StateKnowledge knowledge) {
            this.knowledge = knowledge;
        }

        /** Adds a monitor; the harness has one of its own to press buttons. */
        public Builder with(EventMonitor monitor) {
            monitors.add(requireNonNull(monitor, "the monitor is null"));
            return this;
        }

        /** Sets the analyze component, in place of the default. */
        public Builder with(EventAnalyze analyzeComponent) {
            analyze = requireNonNull(analyzeComponent, "the analyze component is null");
            return this;
        }

        /** Sets the plan component, in place of the default. */
        public Builder with(EventPlan planComponent) {
            plan = requireNonNull(planComponent, "the plan component is null");
            return this;
        }

        /** Adds an execute component. */
        public Builder with(EventExecute execute) {
            executes.add(requireNonNull(execute, "the execute component is null"));
            return this;
        }

        /** Sets the device: both its monitor and its execute component. */
        public Builder with(SimulatedDevice simulated) {
            device = requireNonNull(simulated, "the device is null");
            return this;
        }

        /** Gives the converter a journal, which a {@link Recording} can replay after the harness is closed. */
        public Builder with(ConverterJournal kept) {
            journal = requireNonNull(kept, "the journal is null");
            return this;
        }

        /** Sets the clock, for a test whose own parts need it earlier; by default there is a new one. */
        public Builder clock(ManualClock manual) {
            clock = requireNonNull(manual, "the clock is null");
            return this;
        }

        /** Changes the loop's options, such as the queue's capacity; it has no threads whatever they say. */
        public Builder options(UnaryOperator<LoopConfig> change) {
            options = requireNonNull(change, "the change of options is null");
            return this;
        }

        /**
         * Builds the converter and starts it.
         *
         * @throws org.evoloop.statemachine.ModelException if models and components do not fit, as {@link
         *     SystemEventConverter#build}
         * @throws IllegalStateException if a component is missing, or belongs to another converter
         */
        public ConverterHarness start() {
            return new ConverterHarness(this);
        }
    }

    /**
     * Operates a control of the controller.
     *
     * @throws IllegalArgumentException if neither model knows the event
     * @throws IllegalStateException if the converter is stopped
     */
    public ConverterHarness press(String event) {
        tester.press(event);
        return settle();
    }

    /** As {@link #press(String)}, for an event with {@code values}. */
    public ConverterHarness press(String event, Values values) {
        tester.press(event, values);
        return settle();
    }

    /**
     * Makes the device do {@code event} by itself and report it: the simulated device takes its transition; without
     * one, the harness reports the event.
     *
     * @throws IllegalStateException if the simulated device has no transition for the event in its state
     */
    public ConverterHarness deviceDoes(String event) {
        if (device != null) {
            transcript.during(() -> device.acts(event));
        } else {
            tester.done(event);
        }
        return settle();
    }

    /**
     * Operates a control on the device.
     *
     * @param deviceActed whether the device acts on it by itself, or only reports it
     */
    public ConverterHarness pressOnDevice(String event, boolean deviceActed) {
        if (device != null && deviceActed) {
            transcript.during(() -> device.button(event));
        } else {
            tester.pressedOnDevice(event, deviceActed);
        }
        return settle();
    }

    /** Reports that the device was found in {@code state} of its model; a simulated device is put there. */
    public ConverterHarness found(String state) {
        if (device != null) {
            device.put(state);
        }
        tester.found(state);
        return settle();
    }

    /**
     * Advances the clock by {@code duration}; everything that becomes due is handled at its time, with all that follows
     * from it.
     */
    public ConverterHarness advance(Duration duration) {
        long end = clock.nanoTime() + duration.toNanos();
        settle();
        do {
            Duration left = Duration.ofNanos(Math.max(0, end - clock.nanoTime()));
            pass(clock.untilNext().filter(next -> next.compareTo(left) < 0).orElse(left));
        } while (clock.nanoTime() < end);
        return this;
    }

    private void pass(Duration duration) {
        atOnce = duration.isZero() ? atOnce + 1 : 0;
        requireProgress(atOnce, "timers without delay follow from timers without delay");
        transcript.during(() -> clock.advance(duration));
        settle();
    }

    private void requireProgress(int rounds, String why) {
        if (rounds > MOST_EVENTS) {
            throw new AssertionError(report("the converter does not come to rest: " + why));
        }
    }

    /** Calls every monitor, and handles everything that waits at this moment. */
    public ConverterHarness settle() {
        transcript.during(this::dealWithAll);
        return this;
    }

    private void dealWithAll() {
        int events = 0;
        for (int quiet = 0; quiet < QUIET_ROUNDS; quiet++) {
            long before = reports();
            monitors.forEach(this::observe);
            while (converter.step()) {
                requireProgress(++events, "events follow from events without end");
            }
            if (reports() != before) {
                quiet = -1;
                requireProgress(++events, "a monitor never stops reporting events");
            }
        }
    }

    private void observe(EventMonitor monitor) {
        try {
            converter.observe(monitor);
        } catch (InterruptedException stop) {
            Thread.currentThread().interrupt();
            throw new AssertionError(
                    monitor.name() + " waits in a converter without threads, or was interrupted", stop);
        }
    }

    /** A counter that grows with every report. */
    private long reports() {
        ConverterStatus now = status();
        ConverterStatus.EventCounts ended = now.events();
        return now.queue().taken()
                + now.queue().dropped()
                + now.queue().refused()
                + ended.handled()
                + ended.ignored()
                + ended.stale()
                + ended.failed();
    }

    /** Advances the clock until the new model is in {@code state}; at most {@link #PATIENCE}. */
    public ConverterHarness until(String state) {
        return until(state, PATIENCE);
    }

    /**
     * Advances the clock from one due timer to the next, until the new model is in {@code state}.
     *
     * @param state the state's name, with or without its history
     * @param within how much time may pass
     * @throws IllegalArgumentException if the new model has no such state
     * @throws AssertionError if it does not get there
     */
    public ConverterHarness until(String state, Duration within) {
        requireState(state);
        long end = clock.nanoTime() + within.toNanos();
        settle();
        while (!isIn(state)) {
            Optional<Duration> next = clock.untilNext();
            if (next.isEmpty()) {
                throw new AssertionError(report("the system never came to " + state + ": nothing more is due"));
            }
            if (clock.nanoTime() + next.get().toNanos() > end) {
                throw new AssertionError(report("the system did not come to " + state + " within " + within));
            }
            pass(next.get());
        }
        return this;
    }

    private void requireState(String state) {
        StateMachine evolved = converter.knowledge().models().evolved();
        if (evolved.alike(new State(state)).isEmpty()) {
            throw new IllegalArgumentException(
                    "the new model has no state " + state + Names.hint(state, evolved.states()));
        }
    }

    private boolean isIn(String state) {
        State now = states().evolved();
        return now.name().equals(state)
                || converter
                        .knowledge()
                        .models()
                        .evolved()
                        .withoutMemory(now)
                        .name()
                        .equals(state);
    }

    /**
     * Requires that device and system are in these states, and that nothing is in doubt.
     *
     * @param original the recorded state of the device, in which a simulated one must really be
     * @param evolved the new model's state
     */
    public ConverterHarness expect(String original, String evolved) {
        Configuration wanted = new Configuration(new State(original), new State(evolved));
        boolean isTrue = device == null || device.state().equals(original);
        if (!states().equals(wanted) || !isTrue || !status().doubt().isEmpty()) {
            throw new AssertionError(report("expected is " + StuckReport.describe(wanted)));
        }
        return this;
    }

    private String report(String what) {
        return new StuckReport(this, device, transcript).text(what);
    }

    /** The recorded states of device and system. */
    public Configuration states() {
        return converter.knowledge().configuration();
    }

    /**
     * The events that were sent and have had their effect, in order.
     *
     * @throws IllegalStateException if SLF4J logs by something else than Logback
     */
    public List<String> sent() {
        return transcript.sent();
    }

    /**
     * The lines of the converter's transcript.
     *
     * @throws IllegalStateException if SLF4J logs by something else than Logback
     */
    public List<String> transcript() {
        return transcript.lines();
    }

    /** The last events and their outcomes, oldest first. */
    public List<HistoryEntry> history() {
        return converter.history();
    }

    /** A snapshot of the converter's status. */
    public ConverterStatus status() {
        return converter.status();
    }

    /** All failures so far, of components and of the code that they call. */
    public List<Failure<Occurrence>> failures() {
        return List.copyOf(failures);
    }

    /** The converter's time. */
    public ManualClock clock() {
        return clock;
    }

    /** The converter itself: for {@code stop}, {@code start}, {@code exchange} and whatever else a test needs. */
    public SystemEventConverter converter() {
        return converter;
    }

    /** Ends the converter. Idempotent. */
    @Override
    public void close() {
        transcript.during(converter::close);
    }
}
