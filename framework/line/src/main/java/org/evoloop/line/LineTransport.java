package org.evoloop.line;

import java.io.Closeable;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.nio.file.Path;
import java.util.List;

/**
 * Opens wires to a controller or device that exchanges lines: {@link #tcp}, {@link #unix}, {@link #program}, or the serial port of the artifact {@code
 * evoloop-serial}. Its {@code toString} names the destination, for messages.
 *
 * <p>Threading: {@link #open} is called by one thread at a time.
 *
 * @since 0.1
 */
public interface LineTransport {

    /**
     * Opens a wire. Waits for a few seconds at most.
     *
     * @throws IOException if that fails; the message names the destination and says how to fix it
     */
    Wire open() throws IOException;

    /** A TCP server, such as a device on the network or a serial adapter with a network socket. */
    static LineTransport tcp(String host, int port) {
        return new TcpTransport(host, port);
    }

    /** A Unix-domain socket of this machine. */
    static LineTransport unix(Path socket) {
        return new UnixTransport(socket);
    }

    /**
     * A program, by its standard input and output. It is started without a shell, and started again when it ends; it is
     * ended with the connection, whatever it does. What it writes to its standard error is logged. Messages show
     * the program and the script that it runs, since other arguments may be secret.
     *
     * @param command the program and its arguments, such as {@code python3 kettle.py}
     * @throws IllegalArgumentException if it names no program
     */
    static LineTransport program(List<String> command) {
        return new ProgramTransport(command);
    }

    /**
     * An open wire.
     *
     * <p>Threading: one thread reads, one at a time writes. Any thread may close the wire, which ends the calls of the
     * others.
     *
     * @since 0.1
     */
    interface Wire extends Closeable {
        /** Bytes from the other end. */
        InputStream input();

        /** Bytes to the other end, sent without delay. */
        OutputStream output();
    }
}
