package org.evoloop.engine.codec;

import java.util.Arrays;
import java.util.List;

/** Writes items as bytes: numbers in as few as they need, texts after their length, no names of groups. */
final class ByteWriter extends ItemWriter {
    static final int TEXT = 0;
    static final int NUMBER = 1;
    static final int FALSE = 2;
    static final int TRUE = 3;

    /** The value bits in each byte of a number; the remaining bit says whether more bytes follow. */
    static final int BITS = 7;

    static final int MORE = 1 << BITS;

    /** Flag in a text's length: each character takes two bytes. */
    static final int WIDE = 1;

    private static final char MOST_NARROW = 0xff;

    /** The most bytes of a number. */
    private static final int MOST_OF_NUMBER = 10;

    private byte[] bytes;
    private int length;

    /** Continues after the first {@code length} bytes of {@code bytes}. */
    ByteWriter(byte[] bytes, int length) {
        this.bytes = bytes;
        this.length = length;
    }

    byte[] written() {
        return Arrays.copyOf(bytes, length);
    }

    private ItemWriter octet(int value) {
        room(1);
        bytes[length++] = (byte) value;
        return this;
    }

    private void room(int more) {
        if (length + more > bytes.length) {
            bytes = Arrays.copyOf(bytes, Math.max(2 * bytes.length, length + more));
        }
    }

    @Override
    ItemWriter begin(String name) {
        return this;
    }

    @Override
    ItemWriter beginKind(String name) {
        return word(name);
    }

    @Override
    ItemWriter beginSome(String name) {
        return octet(1);
    }

    @Override
    void none(String name) {
        octet(0);
    }

    @Override
    ItemWriter word(String word) {
        int code = WordCodes.of(word);
        octet(code);
        return code == WordCodes.OTHER ? text(word) : this;
    }

    @Override
    ItemWriter choice(boolean which, String yes, String no) {
        return octet(which ? 1 : 0);
    }

    @Override
    ItemWriter choice(int which, List<String> words) {
        return octet(which);
    }

    @Override
    ItemWriter number(long number) {
        // Negative numbers near zero become small positive ones.
        return unsigned((number << 1) ^ (number >> (Long.SIZE - 1)));
    }

    private ItemWriter unsigned(long number) {
        room(MOST_OF_NUMBER);
        byte[] to = bytes;
        int next = length;
        long rest = number;
        while ((rest & -MORE) != 0) {
            to[next++] = (byte) (((int) rest & (MORE - 1)) | MORE);
            rest >>>= BITS;
        }
        to[next++] = (byte) rest;
        length = next;
        return this;
    }

    /** Writes one byte per character if that is enough for all of them, else two; so every string can be written. */
    @Override
    ItemWriter text(String words) {
        int count = words.length();
        boolean narrow = isNarrow(words);
        unsigned(((long) count << 1) | (narrow ? 0 : WIDE));
        if (narrow) {
            room(count);
            byte[] to = bytes;
            int from = length;
            for (int at = 0; at < count; at++) {
                to[from + at] = (byte) words.charAt(at);
            }
            length += count;
        } else {
            for (int at = 0; at < count; at++) {
                octet(words.charAt(at) >>> Byte.SIZE);
                octet(words.charAt(at));
            }
        }
        return this;
    }

    private static boolean isNarrow(String words) {
        for (int at = 0; at < words.length(); at++) {
            if (words.charAt(at) > MOST_NARROW) {
                return false;
            }
        }
        return true;
    }

    @Override
    ItemWriter value(Object value) {
        if (value instanceof String words) {
            return octet(TEXT).text(words);
        } else if (value instanceof Boolean truth) {
            return octet(truth ? TRUE : FALSE);
        }
        return octet(NUMBER).text(value.toString());
    }

    @Override
    void end() {}
}
