package org.evoloop.line;

import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.function.Function;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.evoloop.converter.PushMonitor;
import org.evoloop.evolution.Occurrence;
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
    private final Set<String> devicesOwn = new LinkedHashSet<>();

    private record Rule(Pattern line, Function<Matcher, Occurrence> means) {}

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
        events.forEach((line, event) -> controller(Pattern.compile(Pattern.quote(line)), event));
        return this;
    }

    /**
     * Sets a pattern of such lines. Its named groups are the event's values, as numbers if they look like numbers, else
     * as texts.
     */
    public final LineMonitor controller(Pattern line, String event) {
        return rule(line, match -> fromController(event, LineReadings.values(match)));
    }

    /**
     * Sets the lines that report that the device has done something by itself.
     *
     * @param events by line
     */
    public final LineMonitor device(Map<String, String> events) {
        events.forEach((line, event) -> device(Pattern.compile(Pattern.quote(line)), event));
        return this;
    }

    /** Sets a pattern of such lines, as {@link #controller(Pattern, String)} does. */
    public final LineMonitor device(Pattern line, String event) {
        devicesOwn.add(event);
        return rule(line, match -> fromDevice(event, LineReadings.values(match)));
    }

    /**
     * Sets the lines that report the device's state, for example in answer to the lines of {@link
     * LineConnection#greet}.
     *
     * @param states of the original model, by line
     */
    public final LineMonitor found(Map<String, String> states) {
        states.forEach((line, state) -> rule(Pattern.compile(Pattern.quote(line)), match -> foundIn(state)));
        return this;
    }

    private LineMonitor rule(Pattern line, Function<Matcher, Occurrence> means) {
        rules.add(new Rule(line, means));
        return this;
    }

    private void hear(String line) {
        for (Rule rule : rules) {
            Matcher match = rule.line().matcher(line);
            if (match.matches()) {
                push(rule.means().apply(match));
                return;
            }
        }
        LOG.debug("{} ignores '{}'", name(), line);
    }

    @Override
    protected Set<String> spontaneousEvents() {
        return Set.copyOf(devicesOwn);
    }
}
