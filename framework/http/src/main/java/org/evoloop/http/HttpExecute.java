package org.evoloop.http;

import java.io.IOException;
import java.time.Duration;
import java.time.Instant;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.Function;
import org.evoloop.converter.DeviceLink;
import org.evoloop.converter.EventExecute;
import org.evoloop.evolution.Step;
import org.jspecify.annotations.Nullable;

/**
 * Sends events to a device that takes its commands as HTTP requests:
 *
 * <pre>{@code
 * new HttpExecute("Lamp", Map.of("switch", HttpCall.post("http://lamp.local/toggle", "")), Duration.ofSeconds(3))
 *         .asking(HttpCall.get("http://lamp.local/state"), answer -> answer.contains("on") ? "on" : "off");
 * }</pre>
 *
 * <p>A step has been executed when the device answers with a status of 200 to 299. It fails if the answer has another
 * status or does not come in time. In the latter case the request may or may not have arrived: it is never sent again,
 * unless it {@linkplain HttpCall#canBeRepeated() can be}. If the device's state can be asked for, it is asked instead.
 * Redirects are not followed.
 *
 * <p>Threading: as {@link EventExecute}. As a {@link DeviceLink} it reports how the last request went.
 *
 * @since 0.1
 */
public class HttpExecute extends EventExecute implements DeviceLink {
    private final Map<String, HttpCall> calls;
    private final Caller caller;
    private @Nullable HttpCall question;
    private Function<String, String> states = answer -> answer;
    private volatile String trouble = "";
    private volatile @Nullable Instant downSince;

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

    @Override
    protected final Set<String> sendableEvents() {
        return calls.keySet();
    }

    @Override
    protected void send(Step step) throws IOException, InterruptedException {
        HttpCall call = calls.get(step.event().name());
        if (call == null) {
            throw new IllegalArgumentException(name() + " has no request for " + step.event());
        }
        try {
            ask(call, answer -> "");
        } catch (UnansweredException unanswered) {
            if (!locate().equals(Optional.of(step.target().name()))) {
                throw unanswered;
            }
        }
    }

    @Override
    protected Optional<String> locate() throws IOException, InterruptedException {
        HttpCall asked = question;
        return asked == null ? Optional.empty() : Optional.of(states.apply(ask(asked, Reply::body)));
    }

    private String ask(HttpCall call, Caller.Use<String> use) throws IOException, InterruptedException {
        try {
            String answer = caller.call(call, use);
            trouble = "";
            downSince = null;
            return answer;
        } catch (IOException failure) {
            trouble = String.valueOf(failure.getMessage());
            if (downSince == null) {
                downSince = Instant.now();
            }
            throw failure;
        }
    }

    @Override
    public boolean isUp() {
        return trouble.isEmpty();
    }

    @Override
    public Optional<Instant> downSince() {
        return Optional.ofNullable(downSince);
    }

    @Override
    public String describe() {
        return trouble.isEmpty() ? "requests are answered" : trouble;
    }
}
