package org.evoloop.engine.codec;

import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.jspecify.annotations.Nullable;

/**
 * Writes items as bytes: numbers in as few as they need, texts after their length, no names of groups. A writer with a table
 * spells a name out at its first use, and writes its number from then on.
 *
 * <p>Threading: not thread-safe.
 *
 * @since 0.1
 */
public final class ByteWriter extends ItemWriter {
    /** Enough for most snapshots. */
    private static final int CAPACITY = 192;

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

    private final @Nullable Map<String, Integer> table;
    private byte[] bytes = new byte[CAPACITY];
    private int length;

    private ByteWriter(@Nullable Map<String, Integer> table) {
        this.table = table;
    }

    /** One that spells out each name. */
    public ByteWriter() {
        this(null);
    }

    /** One with a table of names. */
    public static ByteWriter withTable() {
        return new ByteWriter(new HashMap<>());
    }

    /** Forgets what was written, but for the names in the table. */
    public void clear() {
        length = 0;
    }

    /** Forgets the names in the table. */
    public void forgetNames() {
        if (table != null) {
            table.clear();
        }
    }

    /** A copy of what was written. */
    public byte[] written() {
        return Arrays.copyOf(bytes, length);
    }

    /** The memory in which the first {@link #length} bytes were written; not a copy. */
    public byte[] array() {
        return bytes;
    }

    /** How many bytes were written. */
    public int length() {
        return length;
    }

    /** Writes one byte. */
    public ByteWriter octet(int value) {
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
    public ItemWriter number(long number) {
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
    public ItemWriter text(String words) {
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

    @Override
    public ItemWriter name(String name) {
        if (table == null) {
            return text(name);
        }
        Integer known = table.get(name);
        if (known != null) {
            return number(known);
        }
        number(table.size()).text(name);
        table.put(name, table.size());
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
        octet(NUMBER);
        long bits = Double.doubleToLongBits((Double) value);
        for (int shift = Long.SIZE - Byte.SIZE; shift >= 0; shift -= Byte.SIZE) {
            octet((int) (bits >>> shift));
        }
        return this;
    }

    @Override
    void end() {}
}
