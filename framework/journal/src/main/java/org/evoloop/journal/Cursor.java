package org.evoloop.journal;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;

/** Reads what {@link Bytes} writes, from one record to the next of a segment. */
final class Cursor {
    /** A record's bytes make no sense, although they match its checksum. */
    static final class Senseless extends RuntimeException {
        Senseless(String what) {
            super(what, null, false, false);
        }
    }

    private final List<String> names = new ArrayList<>();
    private final byte[] bytes;
    private int at;
    private int end;

    Cursor(byte[] bytes) {
        this.bytes = bytes;
    }

    void goTo(int from, int length) {
        at = from;
        end = from + length;
    }

    boolean isAtEnd() {
        return at == end;
    }

    void requireEnd() {
        if (at != end) {
            throw new Senseless((end - at) + " bytes are too many");
        }
    }

    int octet() {
        if (at >= end) {
            throw new Senseless("it ends too early");
        }
        return bytes[at++] & 0xFF;
    }

    boolean truth() {
        int value = octet();
        if (value > 1) {
            throw new Senseless(value + " is neither true nor false");
        }
        return value == 1;
    }

    long number() {
        long value = 0;
        for (int shift = 0; shift < 64; shift += 7) {
            int next = octet();
            value |= (next & 0x7FL) << shift;
            if (next < 0x80) {
                return (value >>> 1) ^ -(value & 1);
            }
        }
        throw new Senseless("a number is too long");
    }

    /** The count of the items that follow; each takes at least a byte. */
    int count() {
        long count = number();
        if (count < 0 || count > end - at) {
            throw new Senseless("a count is " + count);
        }
        return (int) count;
    }

    double fraction() {
        long bits = 0;
        for (int read = 0; read < 8; read++) {
            bits = (bits << 8) | octet();
        }
        return Double.longBitsToDouble(bits);
    }

    String text() {
        int length = count();
        String text = new String(bytes, at, length, StandardCharsets.UTF_8);
        at += length;
        return text;
    }

    String name() {
        long number = number();
        if (number == names.size()) {
            names.add(text());
        } else if (number < 0 || number > names.size()) {
            throw new Senseless("a name has the number " + number + " of " + names.size());
        }
        return names.get((int) number);
    }

    List<String> names() {
        int count = count();
        List<String> all = count == 0 ? List.of() : new ArrayList<>(count);
        for (int read = 0; read < count; read++) {
            all.add(name());
        }
        return all;
    }
}
