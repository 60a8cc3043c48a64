package org.evoloop.roomba.session.connection;

import java.nio.charset.StandardCharsets;

/**
 * The first bytes received, to identify the device at the other end if it does not answer like a Roomba.
 *
 * <p>Threading: thread-safe.
 *
 * @since 0.1
 */
public final class FirstBytes {
    private static final int KEPT = 64;

    private final byte[] bytes = new byte[KEPT];
    private int length;

    /** No bytes yet. */
    public FirstBytes() {}

    /** Adds the next {@code count} bytes of a buffer; only the first ones are stored. */
    public synchronized void take(byte[] buffer, int count) {
        int taken = Math.min(count, KEPT - length);
        System.arraycopy(buffer, 0, bytes, length, taken);
        length += taken;
    }

    synchronized boolean isEmpty() {
        return length == 0;
    }

    /** The probable problem, and how to fix it. */
    synchronized String diagnosis(String port) {
        if (length == 0) {
            return port
                    + ": no answer at 115200 nor 19200 baud; the robot is asleep or off, or its cable is not plugged in. "
                    + "Press CLEAN to wake it, or plug the cable in";
        }
        String text = new String(bytes, 0, length, StandardCharsets.ISO_8859_1);
        long printable = text.chars()
                .filter(character -> character == '\r' || character == '\n' || (character >= ' ' && character < 127))
                .count();
        if (text.contains("Roomba") || text.contains("bat:")) {
            return port
                    + ": a Roomba is there, but it sends no sensor values; take out its battery for a moment to reset it";
        }
        if (printable * 10 >= length * 9L) {
            return port + ": this is not a Roomba, it says '" + text.strip().replaceAll("\\s+", " ")
                    + "'; choose the port that the robot's cable is on";
        }
        return port
                + ": bytes come, but no frames: the robot uses another baud rate than 115200 and 19200, or this is not a "
                + "Roomba. Take out its battery for a moment to reset the rate, or choose another port";
    }
}
