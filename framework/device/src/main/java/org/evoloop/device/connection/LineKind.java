package org.evoloop.device.connection;

import java.nio.file.Path;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.evoloop.device.Connection;
import org.evoloop.device.ConnectionKind;
import org.evoloop.device.FileModels;
import org.evoloop.device.file.Section;
import org.evoloop.line.LineTransport;
import org.evoloop.serial.SerialTransport;

/**
 * {@code lines: tcp://HOST:PORT}: a device or a controller that exchanges lines of text.
 *
 * <p>Threading: as {@link ConnectionKind}.
 *
 * @since 0.1
 */
public final class LineKind implements ConnectionKind {
    private static final Pattern TCP = Pattern.compile("tcp://(?<host>[^/:]+|\\[[^\\]]+\\]):(?<port>[0-9]{1,9})/?");
    private static final Pattern SERIAL = Pattern.compile("serial://(?<port>/.+)");
    private static final Pattern UNIX = Pattern.compile("unix://(?<path>/.+)");
    private static final int FASTEST = 4_000_000;
    private static final int USUAL = 9600;

    /** For {@link java.util.ServiceLoader}. */
    public LineKind() {}

    @Override
    public String key() {
        return "lines";
    }

    @Override
    public Connection read(String name, Section section, FileModels models) {
        int baud = section.number("baud", 1, FASTEST).orElse(USUAL);
        LineTransport transport =
                section.value(key(), address -> transport(address, baud)).orElse(null);
        return LineFileConnection.read(name, key(), transport, section, models);
    }

    private static LineTransport transport(String address, int baud) {
        Matcher tcp = TCP.matcher(address);
        Matcher serial = SERIAL.matcher(address);
        Matcher unix = UNIX.matcher(address);
        if (tcp.matches()) {
            return LineTransport.tcp(tcp.group("host"), Integer.parseInt(tcp.group("port")));
        } else if (serial.matches()) {
            return SerialTransport.at(serial.group("port"), baud);
        } else if (unix.matches()) {
            return LineTransport.unix(Path.of(unix.group("path")));
        }
        throw new IllegalArgumentException("'" + address
                + "' is no address; write tcp://HOST:PORT, serial:///dev/ttyUSB0 or unix:///run/device.sock");
    }
}
