package org.evoloop.gpio;

import java.time.Duration;
import java.util.HashMap;
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
 *         .hold("heat", 25, true)
 *         .hold("cool", 25, false)
 * }</pre>
 *
 * <p>A press has been executed when the pin has been high for its duration and then low for as long, so that two presses
 * do not merge into one. Afterwards the pin is low, even after a failure. A pin that is held stays as it is until another
 * event changes it.
 *
 * <p>Lifecycle: add all events before the converter is built.
 *
 * <p>Threading: as {@link EventExecute}.
 *
 * @since 0.1
 */
public class GpioExecute extends EventExecute {
    private final Clock clock;
    private final Pins pins;
    private final Map<Integer, OutputPin> outputs = new HashMap<>();
    private final Map<String, Signal> signals = new HashMap<>();

    /** How a pin sends an event. */
    private interface Signal {
        void send() throws InterruptedException;
    }

    /** A component that sends no event yet; see {@link #pulse} and {@link #hold}. */
    public GpioExecute(String name, Pins pins, Clock clock) {
        super(name);
        this.pins = pins;
        this.clock = clock;
    }

    /**
     * A component that sends these events.
     *
     * @param name its name in the console, unique within a converter
     * @param outputs GPIO numbers, by event
     * @param press the duration of a press
     * @throws IllegalArgumentException if a pin cannot be used
     */
    public GpioExecute(String name, Pins pins, Clock clock, Map<String, Integer> outputs, Duration press) {
        this(name, pins, clock);
        outputs.forEach((event, pin) -> pulse(event, pin, press));
    }

    /**
     * Adds an event that is a press.
     *
     * @throws IllegalArgumentException if the pin cannot be used
     */
    public final GpioExecute pulse(String event, int pin, Duration press) {
        Clock.requireDelay(press);
        OutputPin output = output(pin);
        signals.put(event, () -> {
            output.set(true);
            try {
                clock.sleep(press);
            } finally {
                output.set(false);
            }
            clock.sleep(press);
        });
        return this;
    }

    /**
     * Adds an event that sets a pin high or low, and leaves it so; another event may do the opposite.
     *
     * @throws IllegalArgumentException if the pin cannot be used
     */
    public final GpioExecute hold(String event, int pin, boolean high) {
        OutputPin output = output(pin);
        signals.put(event, () -> output.set(high));
        return this;
    }

    private OutputPin output(int pin) {
        return outputs.computeIfAbsent(pin, number -> new OutputPin(pins, number));
    }

    @Override
    protected final Set<String> sendableEvents() {
        return Set.copyOf(signals.keySet());
    }

    @Override
    protected void send(Step step) throws InterruptedException {
        Signal signal = signals.get(step.event().name());
        if (signal == null) {
            throw new IllegalArgumentException(name() + " has no pin for " + step.event());
        }
        signal.send();
    }
}
