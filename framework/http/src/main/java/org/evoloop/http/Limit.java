package org.evoloop.http;

import java.io.FilterInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.net.Socket;
import java.net.SocketTimeoutException;
import java.time.Duration;

/**
 * The time left for a request; a slow answer does not extend it.
 *
 * <p>Threading: for one thread.
 */
final class Limit {
    private final long deadlineNanos;

    Limit(Duration limit) {
        deadlineNanos = System.nanoTime() + limit.toNanos();
    }

    /**
     * The time left, at least 1.
     *
     * @throws SocketTimeoutException if none is left
     */
    int millis() throws SocketTimeoutException {
        long left = deadlineNanos - System.nanoTime();
        if (left <= 0) {
            throw new SocketTimeoutException("it took too long");
        }
        return (int) Math.min(Integer.MAX_VALUE, left / 1_000_000 + 1);
    }

    /** The bytes that {@code socket} delivers in time. */
    InputStream of(Socket socket) throws IOException {
        return new FilterInputStream(socket.getInputStream()) {
            @Override
            public int read() throws IOException {
                byte[] one = new byte[1];
                return read(one, 0, 1) < 0 ? -1 : one[0] & 0xff;
            }

            @Override
            public int read(byte[] bytes, int start, int length) throws IOException {
                socket.setSoTimeout(millis());
                return super.read(bytes, start, length);
            }
        };
    }
}
