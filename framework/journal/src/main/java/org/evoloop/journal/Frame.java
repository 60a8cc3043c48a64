package org.evoloop.journal;

import java.lang.invoke.MethodHandles;
import java.lang.invoke.VarHandle;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.zip.CRC32C;

/**
 * The layout of a record in a file: eight bytes, big-endian, then the payload, then zeros up to a multiple of eight.
 * The eight are the payload's length in 24 bits, a check of that in 8 bits, and the payload's CRC32C in 32 bits. They
 * are written after the payload and are never all zero, so zeros mean that no record was completed there.
 *
 * <p>A record begins at a multiple of eight, since only there its header is written atomically: elsewhere the
 * interpreter and C1 write a {@code long} in parts, and a kill in between would leave an invalid header.
 */
final class Frame {
    static final int HEADER_BYTES = 8;
    static final int MOST_BYTES = (1 << 24) - 1;

    /** Longer than most records of an event. */
    static final int SHORT_BYTES = 256;

    /** Makes the header of an empty record non-zero. */
    private static final int SALT = 0xA5;

    /** The polynomial of CRC32C, reflected. */
    private static final int POLYNOMIAL = 0x82F63B78;

    /** For each four bits, what they change in the sum when they are shifted out. */
    private static final int[] FOUR_BITS = new int[16];

    static {
        for (int bits = 0; bits < FOUR_BITS.length; bits++) {
            int sum = bits;
            for (int bit = 0; bit < 4; bit++) {
                sum = (sum & 1) == 0 ? sum >>> 1 : (sum >>> 1) ^ POLYNOMIAL;
            }
            FOUR_BITS[bits] = sum;
        }
    }

    private static final VarHandle LONG = MethodHandles.byteBufferViewVarHandle(long[].class, ByteOrder.BIG_ENDIAN);

    private Frame() {}

    /**
     * Writes eight bytes atomically, at a multiple of eight; however the process ends, everything written before is
     * there.
     */
    static void finish(ByteBuffer file, int at, long eight) {
        LONG.setRelease(file, at, eight);
    }

    /** Writes the eight bytes at a multiple of eight as they are, atomically. */
    static void touch(ByteBuffer file, int at) {
        LONG.getAndBitwiseOr(file, at, 0L);
    }

    /** The size of a payload in bytes, including the zeros after it. */
    static int padded(int length) {
        return (length + 7) & -8;
    }

    static long header(int length, int crc) {
        return ((long) length << 40) | ((long) check(length) << 32) | (crc & 0xFFFF_FFFFL);
    }

    /** A check that differs for lengths that differ in one bit. */
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

    /** The sum of several headers, in their order: another header anywhere gives another sum. */
    static long sum(long before, long header) {
        long mixed = (before ^ header) * 0x9E3779B97F4A7C15L;
        return mixed ^ (mixed >>> 29);
    }

    /** The CRC32C of some bytes of an array. */
    static int crcOf(byte[] bytes, int from, int length) {
        CRC32C crc = new CRC32C();
        crc.update(bytes, from, length);
        return (int) crc.getValue();
    }

    /**
     * The CRC32C of the first bytes of an array. The JDK's method may need tables of 8 kB, which have left the
     * processor's caches when a rare event needs them; this one is slower for long records.
     */
    static int crcOfShort(byte[] bytes, int length) {
        int sum = -1;
        for (int index = 0; index < length; index++) {
            sum ^= bytes[index] & 0xFF;
            sum = (sum >>> 4) ^ FOUR_BITS[sum & 0xF];
            sum = (sum >>> 4) ^ FOUR_BITS[sum & 0xF];
        }
        return ~sum;
    }
}
