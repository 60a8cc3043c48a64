package org.evoloop.line;

import java.io.Closeable;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;

/**
 * The way to what speaks in lines: {@link #tcp}, or the serial port of the artifact {@code evoloop-serial}. Its
 * {@code toString} says where it leads, for messages.
 *
 * <p>Threading: {@link #open} is called by one thread at a time.
 *
 * @since 0.1
 */
public interface LineTransport {

    /**
     * Opens a wire. Waits for some seconds at most.
     *
     * @throws IOException if there is none now; the message names the place and says how to fix it
     */
    Wire open() throws IOException;

    /** A TCP server, such as a device on the network or a serial adapter with a network socket. */
    static LineTransport tcp(String host, int port) {
        return new TcpTransport(host, port);
    }

    /**
     * What is open.
     *
     * <p>Threading: one thread reads, one at a time writes, and any may close, which ends what the others do.
     *
     * @since 0.1
     */
    interface Wire extends Closeable {
        /** What comes from the other end. */
        InputStream input();

        /** What goes to the other end, without delay. */
        OutputStream output();
    }
}
