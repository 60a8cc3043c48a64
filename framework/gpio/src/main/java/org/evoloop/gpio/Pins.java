package org.evoloop.gpio;

import com.pi4j.Pi4J;
import com.pi4j.context.Context;
import com.pi4j.exception.Pi4JException;
import com.pi4j.io.gpio.digital.DigitalInput;
import com.pi4j.io.gpio.digital.DigitalInputConfigBuilder;
import com.pi4j.io.gpio.digital.DigitalOutput;
import com.pi4j.io.gpio.digital.DigitalOutputConfigBuilder;
import com.pi4j.io.gpio.digital.DigitalState;
import com.pi4j.io.gpio.digital.PullResistance;
import com.pi4j.plugin.gpiod.provider.gpio.digital.GpioDDigitalInputProvider;
import com.pi4j.plugin.gpiod.provider.gpio.digital.GpioDDigitalOutputProvider;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashSet;
import java.util.Set;

/**
 * The pins of a Raspberry Pi's header, by their GPIO numbers: GPIO 17 is pin 11 of the header.
 *
 * <p>Lifecycle: {@link #open}; {@link #close} releases all pins and sets the outputs low.
 *
 * <p>Threading: all methods may be called from any thread.
 *
 * @since 0.1
 */
public final class Pins implements AutoCloseable {
    /** The lowest number of a pin on the header that is not reserved. */
    public static final int LOWEST = 2;

    /** The highest number of a pin on the header. */
    public static final int HIGHEST = 27;

    private static final Path MODEL = Path.of("/proc/device-tree/model");

    private final Context context;
    private final Set<Integer> taken = new HashSet<>();

    private Pins(Context context) {
        this.context = context;
    }

    /** The pins of another Pi4J context, such as one with its mock in tests; {@link #close} shuts it down. */
    public static Pins of(Context context) {
        return new Pins(context);
    }

    /**
     * The pins of this computer.
     *
     * @throws IOException if it has none, or this user may not use them; the message says what to do
     */
    public static Pins open() throws IOException {
        requireRaspberryPi(MODEL);
        try {
            return new Pins(Pi4J.newContextBuilder()
                    .add(GpioDDigitalInputProvider.newInstance(), GpioDDigitalOutputProvider.newInstance())
                    .disableShutdownHook()
                    .build());
        } catch (Pi4JException | LinkageError failure) {
            throw new IOException(
                    "the GPIO pins cannot be used (" + failure.getMessage()
                            + "); the user must be in the group gpio: sudo usermod -aG gpio "
                            + System.getProperty("user.name"),
                    failure);
        }
    }

    static void requireRaspberryPi(Path model) throws IOException {
        String name = Files.isReadable(model) ? Files.readString(model).replace("\0", "") : "";
        if (!name.contains("Raspberry Pi")) {
            throw new IOException("this computer has no GPIO pins: it is "
                    + (name.isEmpty() ? "no Raspberry Pi" : "a " + name + ", not a Raspberry Pi")
                    + "; run it on one, or leave the pins out");
        }
    }

    /** A switch between the pin and ground; the Pi's internal pull-up resistor is on. */
    DigitalInput switchAt(int pin) {
        return use(
                pin,
                () -> context.create(
                        DigitalInputConfigBuilder.newInstance(context)
                                .id("switch-" + pin)
                                .address(pin)
                                .pull(PullResistance.PULL_UP)
                                .build(),
                        DigitalInput.class));
    }

    /** An output, which is low initially and after the pins are closed. */
    DigitalOutput outputAt(int pin) {
        return use(
                pin,
                () -> context.create(
                        DigitalOutputConfigBuilder.newInstance(context)
                                .id("output-" + pin)
                                .address(pin)
                                .initial(DigitalState.LOW)
                                .shutdown(DigitalState.LOW)
                                .build(),
                        DigitalOutput.class));
    }

    private interface Creation<T> {
        T create() throws Pi4JException;
    }

    private synchronized <T> T use(int pin, Creation<T> creation) {
        if (pin < LOWEST || pin > HIGHEST) {
            throw new IllegalArgumentException(
                    "there is no GPIO " + pin + "; the header has GPIO " + LOWEST + " to " + HIGHEST);
        }
        if (!taken.add(pin)) {
            throw new IllegalArgumentException("GPIO " + pin + " is used twice; give each a pin of its own");
        }
        try {
            return creation.create();
        } catch (Pi4JException failure) {
            throw new IllegalArgumentException(
                    "GPIO " + pin + " cannot be used (" + failure.getMessage()
                            + "); another program may have it, or the user is not in the group gpio",
                    failure);
        }
    }

    /** Idempotent. */
    @Override
    public void close() {
        context.shutdown();
    }
}
