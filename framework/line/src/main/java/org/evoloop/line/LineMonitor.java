package org.evoloop.line;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.function.Function;
import java.util.regex.Pattern;
import org.evoloop.converter.PushMonitor;
import org.evoloop.evolution.Occurrence;
import org.evoloop.payload.Match;
import org.evoloop.payload.Meanings;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * A monitor of a controller or a device that reports in lines of text what happens:
 *
 * <pre>{@code
 * new LineMonitor("Fan", connection)
 *         .controller(Map.of("button power", "power", "button speed", "speed"))
 *         .device(Map.of("overheated", "overheat"))
 *         .found(Map.of("is off", "Off", "is low", "Low"));
 * }</pre>
 *
 * <p>The first rule that matches a line is used; a line without a matching rule is ignored.
 *
 * <p>Lifecycle: add all rules before the connection is opened.
 *
 * <p>Threading: as {@link PushMonitor}.
 *
 * @since 0.1
 */
public class LineMonitor extends PushMonitor {
    private static final Logger LOG = LoggerFactory.getLogger(LineMonitor.class);

    private final List<Rule> rules = new CopyOnWriteArrayList<>();

    private record Rule(Meanings meanings, Function<Meanings.Meaning, Occurrence> means) {}

    /** @param name its name in the console, unique within a converter */
    @SuppressWarnings("this-escape")
    public LineMonitor(String name, LineConnection connection) {
        super(name);
        connection.listen(this::hear);
    }

    /**
     * Sets the lines that report that a control of the controller was operated.
     *
     * @param events by line
     */
    public final LineMonitor controller(Map<String, String> events) {
        return controller(Meanings.of(events));
    }

    /**
     * Sets a pattern of such lines. Its named groups are the event's values, as numbers if they look like numbers, else
     * as texts.
     */
    public final LineMonitor controller(Pattern line, String event) {
        return controller(Meanings.NONE.with(Match.matching(line), event));
    }

    /** As {@link #controller(Map)}, with JSON, patterns and values. */
    public final LineMonitor controller(Meanings events) {
        controllerRaises(events.names());
        return rule(events, event -> fromController(event.name(), event.values()));
    }

    /**
     * Sets the lines that report that the device has done something by itself.
     *
     * @param events by line
     */
    public final LineMonitor device(Map<String, String> events) {
        return device(Meanings.of(events));
    }

    /** Sets a pattern of such lines, as {@link #controller(Pattern, String)} does. */
    public final LineMonitor device(Pattern line, String event) {
        return device(Meanings.NONE.with(Match.matching(line), event));
    }

    /** As {@link #device(Map)}, with JSON, patterns and values. */
    public final LineMonitor device(Meanings events) {
        deviceRaises(events.names());
        return rule(events, event -> fromDevice(event.name(), event.values()));
    }

    /**
     * Sets the lines that report the device's state, for example in answer to the lines of {@link
     * LineConnection#greet}.
     *
     * @param states of the original model, by line
     */
    public final LineMonitor found(Map<String, String> states) {
        return found(Meanings.of(states));
    }

    /** As {@link #found(Map)}, with JSON and patterns. */
    public final LineMonitor found(Meanings states) {
        return rule(states, state -> foundIn(state.name()));
    }

    private LineMonitor rule(Meanings meanings, Function<Meanings.Meaning, Occurrence> means) {
        rules.add(new Rule(meanings, means));
        return this;
    }

    private void hear(String line) {
        for (Rule rule : rules) {
            Optional<Meanings.Meaning> meaning = rule.meanings().of(line);
            if (meaning.isPresent()) {
                push(rule.means().apply(meaning.get()));
                return;
            }
        }
        LOG.debug("{} ignores '{}'", name(), line);
    }
}
