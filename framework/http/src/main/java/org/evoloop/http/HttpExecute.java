package org.evoloop.http;

import java.io.IOException;
import java.time.Duration;
import java.time.Instant;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.ReentrantLock;
import java.util.function.Function;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.evoloop.converter.DeviceLink;
import org.evoloop.converter.EventExecute;
import org.evoloop.evolution.Configuration;
import org.evoloop.evolution.Step;
import org.evoloop.payload.Meanings;
import org.evoloop.payload.Rest;
import org.evoloop.payload.Template;
import org.evoloop.time.Clock;
import org.jspecify.annotations.Nullable;

/**
 * Sends events to a device that takes its commands as HTTP requests:
 *
 * <pre>{@code
 * new HttpExecute("Lamp", Map.of("switch", HttpCall.post("http://lamp.local/toggle", "")), Duration.ofSeconds(3))
 *         .asking(HttpCall.get("http://lamp.local/state"), answer -> answer.contains("on") ? "on" : "off");
 * }</pre>
 *
 * <p>Address and body may contain the event's values, see {@link Template}.
 *
 * <p>A step has been executed when the device answers with a status that the call {@linkplain HttpCall#accepting accepts}. It fails if the answer has another
 * status or does not come in time. In the latter case the request may or may not have arrived: it is never sent again,
 * unless it {@linkplain HttpCall#canBeRepeated() can be}. If the device's state can be asked for, it is asked instead.
 * Redirects are not followed.
 *
 * <p>While the converter runs, it is checked every 10 s that the device is there: by the question for its state, or
 * else by connecting to it, without a request. As a {@link DeviceLink} this component reports how the newest request or
 * check went.
 *
 * <p>Threading: as {@link EventExecute}; the checks have a thread of their own.
 *
 * @since 0.1
 */
public class HttpExecute extends EventExecute implements DeviceLink {
    private final Map<String, HttpCall> calls;
    private final Caller caller;
    private @Nullable HttpCall question;
    private Function<String, String> states = answer -> answer;
    private final Health health;
    private Duration period = Duration.ofSeconds(10);
    private @Nullable Thread watch;
    private @Nullable ReentrantLock turn;
    private @Nullable HttpPoll poll;
    private @Nullable Rest rest;

    /**
     * A component that sends these events.
     *
     * @param name its name in the console, unique within a converter
     * @param calls the calls to send, by event
     * @param limit the time limit for the device's answer
     */
    public HttpExecute(String name, Map<String, HttpCall> calls, Duration limit) {
        super(name);
        this.calls = Map.copyOf(calls);
        this.caller = new Caller(limit);
        this.health = new Health(devices().map(HttpCall::device).collect(Collectors.joining(" and ")), 1);
    }

    /** A call to each of the devices, usually one. */
    private Stream<HttpCall> devices() {
        Map<String, HttpCall> devices = new TreeMap<>();
        calls.values().forEach(call -> devices.put(call.device(), call));
        return devices.values().stream();
    }

    /** Sets how often it is checked that the device is there; 10 s by default. */
    public final HttpExecute watch(Duration every) {
        period = every;
        return this;
    }

    /**
     * Sets a question for the device's state, asked when a request may not have arrived and whenever the converter is
     * in doubt.
     *
     * @param call the question, which may be repeated
     * @param state maps an answer's body to a state of the original model
     */
    public final HttpExecute asking(HttpCall call, Function<String, String> state) {
        question = call.canBeRepeated();
        states = state;
        return this;
    }

    /** As {@link #asking(HttpCall, Function)}; an answer without a meaning is no answer. */
    public final HttpExecute asking(HttpCall call, Meanings meanings) {
        return asking(
                call,
                answer -> meanings.nameOf(answer)
                        .orElseThrow(() -> new IllegalStateException(
                                call + " was answered with something that is no known state of the device")));
    }

    /** Sets how long the device needs after each request before it takes the next one. */
    public final HttpExecute readyAfter(Duration pause, Clock clock) {
        rest = new Rest(clock, pause);
        return this;
    }

    /**
     * Tells a monitor of the same device of each step.
     *
     * @return the lock that is held while a step is carried out, so that the monitor's questions are not asked meanwhile
     */
    final ReentrantLock beside(HttpPoll monitor) {
        poll = monitor;
        if (turn == null) {
            turn = new ReentrantLock(true);
        }
        return turn;
    }

    @Override
    protected final Set<String> sendableEvents() {
        return calls.keySet();
    }

    @Override
    protected void awaitReady(Step step) throws InterruptedException {
        if (rest != null) {
            rest.await();
        }
        if (poll != null) {
            poll.beforeStep();
        }
    }

    @Override
    protected void send(Step step) throws IOException, InterruptedException {
        HttpCall call = calls.get(step.event().name());
        if (call == null) {
            throw new IllegalArgumentException(name() + " has no request for " + step.event());
        }
        HttpCall filled = call.with(values());
        ReentrantLock held = turn;
        if (held == null) {
            send(step, filled);
            return;
        }
        held.lockInterruptibly();
        try {
            send(step, filled);
            // Before the next question, whose answer then comes after the step.
            tookEffect();
        } finally {
            held.unlock();
        }
    }

    private void send(Step step, HttpCall call) throws IOException, InterruptedException {
        try {
            health.noting(() -> caller.call(call, answer -> ""));
        } catch (UnansweredException unanswered) {
            if (!locate().equals(Optional.of(step.target().name()))) {
                throw unanswered;
            }
        } finally {
            if (rest != null) {
                rest.begin();
            }
            if (poll != null) {
                poll.afterStep();
            }
        }
    }

    @Override
    protected Optional<String> locate() throws IOException, InterruptedException {
        HttpCall asked = question;
        return asked == null ? Optional.empty() : Optional.of(states.apply(ask(asked)));
    }

    private String ask(HttpCall asked) throws IOException, InterruptedException {
        return health.noting(() -> caller.call(asked, ReceivedReply::body));
    }

    @Override
    protected synchronized void settled(Configuration now) {
        if (watch == null) {
            watch = new Thread(this::look, "http-" + name());
            watch.setDaemon(true);
            watch.start();
        }
    }

    @Override
    protected synchronized void released() {
        if (watch != null) {
            watch.interrupt();
            watch = null;
        }
    }

    private void look() {
        try {
            while (!Thread.currentThread().isInterrupted()) {
                check();
                TimeUnit.NANOSECONDS.sleep(period.toNanos());
            }
        } catch (InterruptedException end) {
            // The converter has stopped.
        }
    }

    private void check() throws InterruptedException {
        HttpCall asked = question;
        try {
            if (asked == null) {
                health.noting(this::reach);
            } else {
                ask(asked);
            }
        } catch (IOException gone) {
            // The status says so.
        }
    }

    private boolean reach() throws IOException, InterruptedException {
        for (HttpCall call : devices().toList()) {
            caller.reach(call);
        }
        return true;
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
    public String describe() {
        return health.describe();
    }
}
