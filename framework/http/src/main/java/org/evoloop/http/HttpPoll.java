package org.evoloop.http;

import java.io.IOException;
import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.RejectedExecutionException;
import java.util.concurrent.locks.ReentrantLock;
import java.util.function.Consumer;
import org.evoloop.converter.ConverterStatus;
import org.evoloop.converter.DeviceLink;
import org.evoloop.converter.PushMonitor;
import org.evoloop.converter.SystemEventConverter;
import org.evoloop.function.Reading;
import org.evoloop.payload.Inference;
import org.evoloop.payload.Meanings;
import org.evoloop.payload.Meanings.Meaning;
import org.evoloop.payload.Part;
import org.evoloop.payload.Readings;
import org.evoloop.payload.Rest;
import org.evoloop.payload.Steady;
import org.evoloop.time.Clock;
import org.jspecify.annotations.Nullable;

/**
 * A monitor of a device that must be asked again and again, since it never calls:
 *
 * <pre>{@code
 * HttpPoll espresso = new HttpPoll("Machine", converter, HttpCall.get("http://espresso.local/state"),
 *                 Duration.ofSeconds(1), Duration.ofSeconds(2))
 *         .found(Meanings.at("/state", Map.of("off", "Off", "ready", "Ready")))
 *         .inferring()
 *         .reading("water", Part.at("/temp"), "°C");
 * converter.addMonitor(espresso);
 * converter.addLink(espresso);
 * }</pre>
 *
 * <p>What an answer means is reported when it changes; a state, whenever the converter's record differs. What must
 * {@linkplain Meanings#lasting(Duration) hold for a time} counts at the first answer after that time.
 *
 * <p>Lifecycle: configure it, then {@link #open} after the converter has been built; {@link #close}.
 *
 * <p>Threading: as {@link PushMonitor}; the questions have a thread of their own.
 *
 * @since 0.1
 */
public class HttpPoll extends PushMonitor implements DeviceLink, AutoCloseable {
    private static final int MISSES = 3;

    private final SystemEventConverter converter;
    private final HttpCall question;
    private final Duration every;
    private final Caller caller;
    private final Health health;
    private final Readings readings = new Readings();
    private final List<Report> reports = new ArrayList<>();
    private Meanings states = Meanings.NONE;
    private @Nullable Steady steady;
    private ReentrantLock turn = new ReentrantLock();
    private final Rest sinceStep;
    private final Inference inference;
    private boolean inferring;
    private @Nullable Thread thread;
    private boolean closed;

    /** Events that are reported when the answer begins to mean them. */
    private static final class Report {
        private final Meanings events;
        private final Steady steady;
        private final Consumer<Meaning> report;
        private Optional<Meaning> last = Optional.empty();
        private boolean heard;

        private Report(Meanings events, Clock clock, Consumer<Meaning> report) {
            this.events = events;
            this.steady = new Steady(clock, events.lasting());
            this.report = report;
        }

        private void hear(String answer) {
            Optional<Meaning> now = events.of(answer);
            steady.see(now);
            if (!heard || now.isEmpty()) {
                last = now;
            } else if (steady.counts(now.get()) && !last.equals(now)) {
                last = now;
                report.accept(now.get());
            }
            heard = true;
        }
    }

    /**
     * A monitor of a device.
     *
     * @param name its name in the console, unique within a converter
     * @param converter the converter to which it will be added
     * @param question the request, usually a GET; it must have no effect at the device
     * @param every the pause after each answer, more than 0
     * @param limit the time limit for an answer
     */
    public HttpPoll(String name, SystemEventConverter converter, HttpCall question, Duration every, Duration limit) {
        super(name);
        if (every.isZero()) {
            throw new IllegalArgumentException("no device can be asked without a pause; give " + name + " one");
        }
        this.converter = converter;
        this.inference = new Inference(converter, this::spontaneousEvents);
        this.question = question;
        this.every = Clock.requireDelay(every);
        this.sinceStep = new Rest(converter.clock(), every);
        this.caller = new Caller(limit);
        this.health = new Health(question.device(), MISSES);
    }

    /** Sets the states of the original model, by what the answer says. */
    public final HttpPoll found(Meanings meanings) {
        states = meanings;
        steady = new Steady(converter.clock(), meanings.lasting());
        return this;
    }

    /**
     * Declares that a changed state is the device's own event if exactly one leads there from the state in which the
     * converter believes the device to be. Other changes remain findings.
     *
     * @param more events that the device takes by itself, such as those of its own buttons, beside those that its model
     *     declares to be its own
     */
    public final HttpPoll inferring(String... more) {
        inferring = true;
        deviceRaises(List.of(more));
        return this;
    }

    /** Sets events of a controller that the answer reports; each occurs when the answer begins to mean it. */
    public final HttpPoll controller(Meanings events) {
        controllerRaises(events.names());
        reports.add(new Report(events, converter.clock(), event -> push(fromController(event.name(), event.values()))));
        return this;
    }

    /** Sets what the device does by itself; see {@link #controller}. */
    public final HttpPoll device(Meanings events) {
        deviceRaises(events.names());
        reports.add(new Report(events, converter.clock(), event -> push(fromDevice(event.name(), event.values()))));
        return this;
    }

    /** Adds a reading to the status; see {@link Readings#add}. */
    public final HttpPoll reading(String name, Part part, String unit) {
        readings.add("", name, part, unit);
        return this;
    }

    /** Sets how many questions in a row must go unanswered until the device counts as gone; 3 by default. */
    public final HttpPoll downAfter(int misses) {
        health.patience(misses);
        return this;
    }

    /**
     * Declares that a component sends to the same device. Then no question is asked while a step is carried out, so that
     * an answer is either older or newer than the step. Before a step it is asked what the device has done since the last
     * question, unless the last step is so recent that the device may not show its effect yet.
     */
    public final HttpPoll beside(HttpExecute execute) {
        turn = execute.beside(this);
        return this;
    }

    /** A step is about to be sent. */
    final void beforeStep() throws InterruptedException {
        if (isOpen() && sinceStep.isOver()) {
            look();
        }
    }

    private synchronized boolean isOpen() {
        return thread != null && !closed;
    }

    /** A step has been sent. */
    final void afterStep() {
        sinceStep.begin();
    }

    /** Starts asking; does nothing if it was opened before, or is closed. */
    public final synchronized HttpPoll open() {
        if (thread == null && !closed) {
            thread = new Thread(this::run, "http-" + name());
            thread.setDaemon(true);
            thread.start();
        }
        return this;
    }

    private void run() {
        try {
            while (!Thread.currentThread().isInterrupted()) {
                look();
                converter.clock().sleep(every);
            }
        } catch (InterruptedException | RejectedExecutionException end) {
            // It is being closed, or the clock was.
        }
    }

    private void look() throws InterruptedException {
        turn.lockInterruptibly();
        try {
            String answer = health.noting(() -> caller.call(question, ReceivedReply::body));
            readings.hear("", answer);
            reports.forEach(report -> report.hear(answer));
            hearState(answer);
        } catch (IOException missed) {
            if (!health.isUp()) {
                readings.clear();
            }
        } finally {
            turn.unlock();
        }
    }

    private void hearState(String answer) {
        Optional<Meaning> now = states.of(answer);
        Steady lasting = steady;
        if (lasting != null) {
            lasting.see(now);
            now.filter(lasting::counts).ifPresent(state -> locate(state.name()));
        }
    }

    private void locate(String state) {
        ConverterStatus status = converter.status();
        if (!status.doubt().isEmpty() || !status.states().original().name().equals(state)) {
            Optional<String> event = inferring ? inference.eventTo(state) : Optional.empty();
            push(event.map(this::fromDevice).orElseGet(() -> foundIn(state)));
        }
    }

    @Override
    public boolean isUp() {
        return health.isUp();
    }

    @Override
    public Optional<Instant> downSince() {
        return health.downSince();
    }

    @Override
    public List<Reading> readings() {
        return readings.known();
    }

    @Override
    public String describe() {
        return health.describe();
    }

    /** Ends the questions. Idempotent. */
    @Override
    public final synchronized void close() {
        closed = true;
        if (thread != null) {
            thread.interrupt();
        }
    }
}
