package org.evoloop.gpio;

import com.pi4j.io.gpio.digital.DigitalInput;
import com.pi4j.io.gpio.digital.DigitalState;
import java.time.Duration;
import java.util.LinkedHashSet;
import java.util.Set;
import org.evoloop.converter.PushMonitor;
import org.evoloop.time.Clock;

/**
 * A monitor of switches between a pin and ground, such as a push button or a contact of the device:
 *
 * <pre>{@code
 * new GpioMonitor("WallSwitch", pins, clock).controller(17, "switch").device(27, "doorOpened")
 * }</pre>
 *
 * <p>An event occurs when a switch closes. Contacts are debounced: a state counts only after it has lasted for {@link
 * #SETTLED}.
 *
 * <p>Threading: as {@link PushMonitor}.
 *
 * @since 0.1
 */
public class GpioMonitor extends PushMonitor {
    /** How long a state of a contact must last to count. */
    public static final Duration SETTLED = Duration.ofMillis(20);

    private final Pins pins;
    private final Clock clock;
    private final Set<String> devicesOwn = new LinkedHashSet<>();

    /** @param name its name in the console, unique within a converter */
    public GpioMonitor(String name, Pins pins, Clock clock) {
        super(name);
        this.pins = pins;
        this.clock = clock;
    }

    /**
     * Adds a switch that a person operates.
     *
     * @param pin its GPIO number
     * @throws IllegalArgumentException if the pin cannot be used
     */
    public final GpioMonitor controller(int pin, String event) {
        return on(pin, () -> push(fromController(event)));
    }

    /** Adds a contact that closes when the device has done something by itself; see {@link #controller}. */
    public final GpioMonitor device(int pin, String event) {
        devicesOwn.add(event);
        return on(pin, () -> push(fromDevice(event)));
    }

    private GpioMonitor on(int pin, Runnable closed) {
        DigitalInput input = pins.switchAt(pin);
        Contact contact = new Contact(clock, input.state() == DigitalState.LOW, closed);
        input.addListener(change -> contact.changed(change.state() == DigitalState.LOW));
        return this;
    }

    @Override
    protected Set<String> spontaneousEvents() {
        return Set.copyOf(devicesOwn);
    }
}
