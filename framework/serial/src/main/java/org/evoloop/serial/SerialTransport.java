package org.evoloop.serial;

import java.io.IOException;
import org.evoloop.line.LineTransport;
import org.evoloop.link.LinkException;
import org.evoloop.link.SerialLink;
import org.evoloop.link.SerialSettings;

/**
 * Lines over a serial port, with 8 data bits, no parity, one stop bit and no flow control:
 *
 * <pre>{@code
 * new LineConnection(SerialTransport.at("/dev/ttyUSB0", 9600), clock)
 * }</pre>
 *
 * <p>The port may appear later, disappear and reappear. Names in {@code /dev/serial/by-id} do not depend on what else
 * is plugged in. RTS is not asserted, DTR is.
 *
 * <p>Threading: as {@link LineTransport}.
 *
 * @since 0.1
 */
public final class SerialTransport implements LineTransport {
    private final SerialSettings settings;

    private SerialTransport(SerialSettings settings) {
        this.settings = settings;
    }

    /**
     * A port.
     *
     * @param port a path such as {@code /dev/ttyUSB0}, which may be a symbolic link
     * @param baud the rate of the device, such as 9600 or 115200
     * @throws IllegalArgumentException if the port has no name, or the rate is not above 0
     */
    public static SerialTransport at(String port, int baud) {
        return new SerialTransport(new SerialSettings(port).withBaud(baud));
    }

    @Override
    public Wire open() throws IOException {
        try {
            return new SerialWire(SerialLink.open(settings));
        } catch (LinkException failure) {
            throw new IOException(failure.getMessage(), failure);
        }
    }

    @Override
    public String toString() {
        return settings.toString();
    }
}
