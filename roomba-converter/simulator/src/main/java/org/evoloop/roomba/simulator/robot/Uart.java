package org.evoloop.roomba.simulator.robot;

import java.io.ByteArrayOutputStream;

/**
 * What a serial port reads when bytes were sent at another rate: the same levels on the wire, sampled at wrong times.
 */
final class Uart {
    /** A low start bit, eight bits with the lowest first, and a high stop bit. */
    private static final int BITS_PER_BYTE = 10;

    private final byte[] sent;
    private final int length;
    private final double sentPerReadBit;

    private Uart(byte[] sent, int length, double sentPerReadBit) {
        this.sent = sent;
        this.length = length;
        this.sentPerReadBit = sentPerReadBit;
    }

    /** Bytes sent back to back on an idle line, as they are read; also those with a wrong stop bit. */
    static byte[] read(byte[] sent, int length, int sentBaud, int readBaud) {
        return new Uart(sent, length, (double) sentBaud / readBaud).read();
    }

    private byte[] read() {
        ByteArrayOutputStream read = new ByteArrayOutputStream();
        // Time is counted in sent bits. The line was idle before.
        double time = -1;
        while (true) {
            time = next(time, true);
            time = next(time, false);
            if (time >= (long) length * BITS_PER_BYTE) {
                return read.toByteArray();
            }
            int octet = 0;
            for (int bit = 0; bit < 8; bit++) {
                octet |= isHigh(time + sentPerReadBit * (bit + 1.5)) ? 1 << bit : 0;
            }
            read.write(octet);
            time += sentPerReadBit * (BITS_PER_BYTE - 0.5);
        }
    }

    /** The next time at which the line has this level; the end if never. */
    private double next(double from, boolean high) {
        double time = from;
        while (time < (long) length * BITS_PER_BYTE && isHigh(time) != high) {
            time = Math.floor(time) + 1;
        }
        return time;
    }

    private boolean isHigh(double time) {
        long index = (long) time;
        if (time < 0 || index >= (long) length * BITS_PER_BYTE) {
            return true;
        }
        int bit = (int) (index % BITS_PER_BYTE);
        return bit == BITS_PER_BYTE - 1 || (bit > 0 && (sent[(int) (index / BITS_PER_BYTE)] >> (bit - 1) & 1) == 1);
    }
}
