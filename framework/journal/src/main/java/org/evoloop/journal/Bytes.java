package org.evoloop.journal;

import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.Collection;
import java.util.HashMap;
import java.util.Map;

/**
 * The record being written, in reused memory. Whole numbers take as many bytes as they need; a name is spelt out at its
 * first use in a segment, and is a number from then on.
 */
final class Bytes {
    private final Map<String, Integer> names = new HashMap<>();
    private byte[] bytes = new byte[1024];
    private int length;

    void clear() {
        length = 0;
    }

    /** Forgets all names, since another segment begins. */
    void forgetNames() {
        names.clear();
    }

    byte[] array() {
        return bytes;
    }

    int length() {
        return length;
    }

    void octet(int value) {
        if (length == bytes.length) {
            bytes = Arrays.copyOf(bytes, 2 * length);
        }
        bytes[length++] = (byte) value;
    }

    void truth(boolean value) {
        octet(value ? 1 : 0);
    }

    /** Seven bits per byte, lowest first; small negative numbers are short, too. */
    void number(long value) {
        long left = (value << 1) ^ (value >> 63);
        while ((left & ~0x7FL) != 0) {
            octet((int) ((left & 0x7F) | 0x80));
            left >>>= 7;
        }
        octet((int) left);
    }

    void fraction(double value) {
        long bits = Double.doubleToLongBits(value);
        for (int shift = 56; shift >= 0; shift -= 8) {
            octet((int) (bits >>> shift));
        }
    }

    /** A text that is unlikely to be repeated. */
    void text(String text) {
        // Most events have no reason to write, and the code that encodes a text is rarely called.
        if (text.isEmpty()) {
            number(0);
            return;
        }
        byte[] encoded = text.getBytes(StandardCharsets.UTF_8);
        number(encoded.length);
        for (byte each : encoded) {
            octet(each);
        }
    }

    /** A text of the models, or another that is repeated. */
    void name(String name) {
        Integer known = names.get(name);
        if (known != null) {
            number(known);
        } else {
            number(names.size());
            text(name);
            names.put(name, names.size());
        }
    }

    void names(Collection<String> all) {
        number(all.size());
        if (!all.isEmpty()) {
            for (String name : all) {
                name(name);
            }
        }
    }
}
