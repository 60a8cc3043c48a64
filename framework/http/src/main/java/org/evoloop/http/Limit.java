package org.evoloop.http;

import java.io.FilterInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.net.Socket;
import java.net.SocketTimeoutException;
import java.time.Duration;

/**
 * The time that is left for a request, however slowly its answer comes.
 *
 * <p>Threading: for one thread.
 */
final class Limit {
    private final long deadlineNanos;

    Limit(Duration limit) {
        deadlineNanos = System.nanoTime() + limit.toNanos();
    }

    /** At least 1. @throws SocketTimeoutException if there is none left */
    int millis() throws SocketTimeoutException {
        long left = deadlineNanos - System.nanoTime();
        if (left <= 0) {
            throw new SocketTimeoutException("it took too long");
        }
        return (int) Math.min(Integer.MAX_VALUE, left / 1_000_000 + 1);
    }

    /** What comes from {@code socket} in time. */
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
