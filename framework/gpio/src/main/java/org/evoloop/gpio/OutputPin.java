package org.evoloop.gpio;

import com.pi4j.io.gpio.digital.DigitalOutput;

/**
 * An output pin that drives something such as a lamp or a relay.
 *
 * <p>Threading: thread-safe.
 *
 * @since 0.1
 */
public final class OutputPin {
    private final DigitalOutput pin;

    /** @throws IllegalArgumentException if the pin cannot be used */
    public OutputPin(Pins pins, int pin) {
        this.pin = pins.outputAt(pin);
    }

    /** Sets the pin high or low. */
    public void set(boolean high) {
        pin.setState(high);
    }
}
