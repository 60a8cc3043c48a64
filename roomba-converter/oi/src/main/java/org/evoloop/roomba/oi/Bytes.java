package org.evoloop.roomba.oi;

/** Octets and 16-bit numbers as the specification orders them, high byte first, and the check of a value's range. */
final class Bytes {
    private Bytes() {}

    /** The opcode and its data octets: the low eight bits of each number. */
    static byte[] of(Opcode opcode, int... data) {
        byte[] bytes = new byte[1 + data.length];
        bytes[0] = (byte) opcode.code();
        for (int i = 0; i < data.length; i++) {
            bytes[1 + i] = (byte) data[i];
        }
        return bytes;
    }

    static int high(int value) {
        return value >> 8;
    }

    static int unsigned8(byte[] bytes, int offset) {
        return bytes[offset] & 0xFF;
    }

    static int unsigned16(byte[] bytes, int offset) {
        return unsigned8(bytes, offset) << 8 | unsigned8(bytes, offset + 1);
    }

    static int signed16(byte[] bytes, int offset) {
        return (short) unsigned16(bytes, offset);
    }

    static boolean hasBit(int bits, int bit) {
        return (bits >> bit & 1) == 1;
    }

    /**
     * @param unit of the value, empty if it has none
     * @throws IllegalArgumentException naming the field, the value and what is allowed
     */
    static void requireRange(String field, int value, int min, int max, String unit) {
        if (value < min || value > max) {
            String suffix = unit.isEmpty() ? "" : " " + unit;
            throw new IllegalArgumentException(
                    field + " is " + value + suffix + "; allowed is " + min + " to " + max + suffix);
        }
    }
}
