package org.evoloop.line;

import static java.util.Objects.requireNonNull;

import java.io.IOException;
import java.time.Duration;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import org.evoloop.converter.EventExecute;
import org.evoloop.evolution.Step;
import org.evoloop.payload.Rest;
import org.evoloop.payload.Template;
import org.jspecify.annotations.Nullable;

/**
 * Sends events to a device that takes its commands as lines of text:
 *
 * <pre>{@code
 * new LineExecute("Fan", connection, Map.of("power", "PWR", "speed", "SPD"))
 *         .answeredBy("OK", "ERR.*", Duration.ofSeconds(2))
 *         .asking("STATE?", Map.of("is off", "Off", "is low", "Low", "is high", "High"), Duration.ofSeconds(2));
 * }</pre>
 *
 * <p>A step fails if the device cannot be reached or refuses; nothing is sent later or twice. A step also fails if the
 * connection is lost while the line is sent, or the device does not answer; then the device is asked for its state.
 *
 * <p>Threading: as {@link EventExecute}.
 *
 * @since 0.1
 */
public class LineExecute extends EventExecute {
    private final LineConnection connection;
    private final Map<String, Template> lines;
    private @Nullable Answers answers;
    private @Nullable Question question;
    private Rest rest;

    private record Answers(Pattern ok, Pattern any, Duration limit) {}

    private record Question(String line, Pattern answers, Map<String, String> states, Duration limit) {}

    /**
     * A component that sends these events, which count as executed when they are sent.
     *
     * @param name its name in the console, unique within a converter
     * @param lines the lines to send, by event; they may contain the event's values, see {@link Template}
     */
    public LineExecute(String name, LineConnection connection, Map<String, String> lines) {
        super(name);
        this.connection = connection;
        this.rest = new Rest(connection.clock(), Duration.ZERO);
        lines.values().forEach(LineConnection::requireOneLine);
        this.lines = lines.entrySet().stream()
                .collect(Collectors.toUnmodifiableMap(Map.Entry::getKey, entry -> Template.of(entry.getValue())));
    }

    /**
     * Declares that the device answers each line; the event is executed when the device accepts it.
     *
     * @param accepts a regular expression of the answer when it obeys, such as {@code OK}
     * @param refuses a regular expression of the answer when it refuses, such as {@code ERR.*}
     * @param limit the time limit for the answer; after it the step fails, and the connection is renewed
     */
    public final LineExecute answeredBy(String accepts, String refuses, Duration limit) {
        answers = new Answers(
                Pattern.compile(accepts), Pattern.compile("(?:" + accepts + ")|(?:" + refuses + ")"), limit);
        return this;
    }

    /**
     * Sets a question for the device's state, asked when the converter is in doubt.
     *
     * @param line the question
     * @param states the states of the original model, by answer
     * @param limit the time limit for the answer
     */
    public final LineExecute asking(String line, Map<String, String> states, Duration limit) {
        Pattern known =
                Pattern.compile(states.keySet().stream().map(Pattern::quote).collect(Collectors.joining("|")));
        question = new Question(LineConnection.requireOneLine(line), known, Map.copyOf(states), limit);
        return this;
    }

    /** Sets how long the device needs after each line before it takes the next one. */
    public final LineExecute readyAfter(Duration pause) {
        rest = new Rest(connection.clock(), pause);
        return this;
    }

    @Override
    protected void awaitReady(Step step) throws InterruptedException {
        rest.await();
    }

    @Override
    protected final Set<String> sendableEvents() {
        return lines.keySet();
    }

    @Override
    protected void send(Step step) throws IOException, InterruptedException {
        Template template = lines.get(step.event().name());
        if (template == null) {
            throw new IllegalArgumentException(name() + " has no line for " + step.event());
        }
        try {
            send(LineConnection.requireOneLine(template.with(values())));
        } finally {
            rest.begin();
        }
    }

    private void send(String line) throws IOException, InterruptedException {
        Answers expected = answers;
        if (expected == null) {
            connection.send(line);
            return;
        }
        String answer = connection.ask(line, expected.any(), expected.limit(), heard -> {
            if (expected.ok().matcher(heard).matches()) {
                tookEffect();
            }
        });
        if (!expected.ok().matcher(answer).matches()) {
            throw new IOException("the device refuses '" + line + "': " + answer);
        }
    }

    @Override
    protected Optional<String> locate() throws IOException, InterruptedException {
        Question asked = question;
        if (asked == null) {
            return Optional.empty();
        }
        String answer = connection.ask(asked.line(), asked.answers(), asked.limit(), heard -> {});
        return Optional.of(requireNonNull(asked.states().get(answer)));
    }
}
