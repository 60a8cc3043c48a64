package org.evoloop.device.connection;

import java.io.IOException;
import org.evoloop.device.Connection;
import org.evoloop.device.ConnectionKind;
import org.evoloop.device.FileModels;
import org.evoloop.device.file.Section;
import org.evoloop.gpio.Pins;

/**
 * {@code gpio: true}: switches and relays on the pins of this Raspberry Pi.
 *
 * <p>Threading: as {@link ConnectionKind}.
 *
 * @since 0.1
 */
public final class GpioKind implements ConnectionKind {
    private final Source pins;

    /** Opens the pins of a computer. */
    @FunctionalInterface
    interface Source {
        Pins open() throws IOException;
    }

    /** For {@link java.util.ServiceLoader}. */
    public GpioKind() {
        this(Pins::open);
    }

    GpioKind(Source pins) {
        this.pins = pins;
    }

    @Override
    public String key() {
        return "gpio";
    }

    @Override
    public Connection read(String name, Section section, FileModels models) {
        if (!section.flag("gpio").orElse(true)) {
            section.problem("a connection with gpio: false has no pins; leave it out");
        }
        return new GpioFileConnection(name, section.duration("debounce").orElse(null), pins, models);
    }
}
