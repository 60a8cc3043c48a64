package org.evoloop.gpio;

import com.pi4j.io.gpio.digital.DigitalInput;
import com.pi4j.io.gpio.digital.DigitalState;
import java.time.Duration;
import java.util.Set;
import java.util.function.Consumer;
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
 * #SETTLED}, or as long as {@link #debounce} says.
 *
 * <p>Threading: as {@link PushMonitor}.
 *
 * @since 0.1
 */
public class GpioMonitor extends PushMonitor {
    /** How long a state of a contact must last to count, by default. */
    public static final Duration SETTLED = Duration.ofMillis(20);

    private final Pins pins;
    private final Clock clock;
    private Duration debounce = SETTLED;

    /** @param name its name in the console, unique within a converter */
    public GpioMonitor(String name, Pins pins, Clock clock) {
        super(name);
        this.pins = pins;
        this.clock = clock;
    }

    /** Sets how long a state must last to count, for the pins that are added afterwards. */
    public final GpioMonitor debounce(Duration lasting) {
        debounce = Clock.requireDelay(lasting);
        return this;
    }

    /**
     * Adds a switch that a person operates.
     *
     * @param pin its GPIO number
     * @throws IllegalArgumentException if the pin cannot be used
     */
    public final GpioMonitor controller(int pin, String event) {
        controllerRaises(Set.of(event));
        return on(pin, () -> push(fromController(event)));
    }

    /** Adds a contact that closes when the device has done something by itself; see {@link #controller}. */
    public final GpioMonitor device(int pin, String event) {
        deviceRaises(Set.of(event));
        return on(pin, () -> push(fromDevice(event)));
    }

    /**
     * Adds a contact that shows in which state the device is, such as that of its lamp or its lid; see {@link
     * #controller}. How it is now is reported at once.
     *
     * @param closed the state of the original model while it is closed; empty if that says nothing
     * @param open the state while it is open; empty if that says nothing
     */
    public final GpioMonitor found(int pin, String closed, String open) {
        Consumer<Boolean> find = isClosed -> {
            String state = isClosed ? closed : open;
            if (!state.isEmpty()) {
                push(foundIn(state));
            }
        };
        find.accept(sense(pin, find));
        return this;
    }

    private GpioMonitor on(int pin, Runnable whenClosed) {
        sense(pin, isClosed -> {
            if (isClosed) {
                whenClosed.run();
            }
        });
        return this;
    }

    /** Whether it is closed now; {@code news} receives later changes. */
    private boolean sense(int pin, Consumer<Boolean> news) {
        DigitalInput input = pins.switchAt(pin);
        boolean closed = input.state() == DigitalState.LOW;
        Contact contact = new Contact(clock, debounce, closed, news);
        input.addListener(change -> contact.changed(change.state() == DigitalState.LOW));
        return closed;
    }
}
