package org.evoloop.gpio;

import static java.util.stream.Collectors.toUnmodifiableMap;

import java.time.Duration;
import java.util.Map;
import java.util.Set;
import org.evoloop.converter.EventExecute;
import org.evoloop.evolution.Step;
import org.evoloop.time.Clock;

/**
 * Sends events to a device by closing its buttons: each pin drives a relay or a transistor across a button of the
 * device.
 *
 * <pre>{@code
 * new GpioExecute("Coffee", pins, clock, Map.of("power", 23, "brew", 24), Duration.ofMillis(200))
 * }</pre>
 *
 * <p>A step has been executed when the pin has been high for the duration of a press and then low for as long, so that
 * two presses do not merge into one. Afterwards the pin is low, even after a failure.
 *
 * <p>Threading: as {@link EventExecute}.
 *
 * @since 0.1
 */
public class GpioExecute extends EventExecute {
    private final Clock clock;
    private final Map<String, OutputPin> outputs;
    private final Duration press;

    /**
     * A component that sends these events.
     *
     * @param name its name in the console, unique within a converter
     * @param outputs GPIO numbers, by event
     * @param press the duration of a press
     * @throws IllegalArgumentException if a pin cannot be used
     */
    public GpioExecute(String name, Pins pins, Clock clock, Map<String, Integer> outputs, Duration press) {
        super(name);
        this.clock = clock;
        this.outputs = outputs.entrySet().stream()
                .collect(toUnmodifiableMap(Map.Entry::getKey, entry -> new OutputPin(pins, entry.getValue())));
        this.press = Clock.requireDelay(press);
    }

    @Override
    protected final Set<String> sendableEvents() {
        return outputs.keySet();
    }

    @Override
    protected void send(Step step) throws InterruptedException {
        OutputPin output = outputs.get(step.event().name());
        if (output == null) {
            throw new IllegalArgumentException(name() + " has no pin for " + step.event());
        }
        output.set(true);
        try {
            clock.sleep(press);
        } finally {
            output.set(false);
        }
        clock.sleep(press);
    }
}
