package org.evoloop.journal;

import java.lang.invoke.MethodHandles;
import java.lang.invoke.VarHandle;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.zip.CRC32C;

/**
 * How a record lies in a file: eight bytes, big-endian, then the payload, then zeros up to a multiple of eight. The
 * eight are the payload's length in 24 bits, a check of that in 8 bits, and the payload's CRC32C in 32 bits. They are
 * written after the payload and are never all zero, so that where they are zero nothing was finished.
 *
 * <p>A record begins at a multiple of eight, since only there its header is written in one piece: elsewhere the
 * interpreter and C1 write a {@code long} by parts, and a kill in between would leave a header that is none.
 */
final class Frame {
    static final int HEADER_BYTES = 8;
    static final int MOST_BYTES = (1 << 24) - 1;

    /** Makes the header of an empty record differ from zeros. */
    private static final int SALT = 0xA5;

    private static final VarHandle LONG = MethodHandles.byteBufferViewVarHandle(long[].class, ByteOrder.BIG_ENDIAN);

    private Frame() {}

    /**
     * Writes eight bytes in one piece, at a multiple of eight; whatever ends the process, what was written before is
     * there.
     */
    static void finish(ByteBuffer file, int at, long eight) {
        LONG.setRelease(file, at, eight);
    }

    /** How many bytes a payload takes together with the zeros after it. */
    static int padded(int length) {
        return (length + 7) & -8;
    }

    static long header(int length, int crc) {
        return ((long) length << 40) | ((long) check(length) << 32) | (crc & 0xFFFF_FFFFL);
    }

    /** Differs for lengths that differ in one bit. */
    private static int check(int length) {
        return ((length >> 16) ^ (length >> 8) ^ length ^ SALT) & 0xFF;
    }

    static boolean isSound(long header) {
        return (int) ((header >>> 32) & 0xFF) == check(length(header));
    }

    static int length(long header) {
        return (int) (header >>> 40);
    }

    static int crc(long header) {
        return (int) header;
    }

    static int crcOf(byte[] bytes, int from, int length) {
        CRC32C crc = new CRC32C();
        crc.update(bytes, from, length);
        return (int) crc.getValue();
    }
}
