package org.evoloop.engine.codec;

import java.util.ArrayList;
import java.util.List;
import org.jspecify.annotations.Nullable;

/**
 * The items that {@link ByteWriter} has written. The names that a writer with a table has written are kept from one part of the
 * bytes to the next.
 *
 * <p>Errors: what cannot be read is a {@link CodecException}. A count is not checked: whoever makes a list of many items must
 * not reserve memory for it in advance.
 *
 * <p>Threading: not thread-safe.
 *
 * @since 0.1
 */
public final class ByteItems extends Items {
    private final String title;
    private final byte[] bytes;
    private final @Nullable List<String> table;
    private int place;
    private int end;

    private ByteItems(String title, byte[] bytes, int from, @Nullable List<String> table) {
        this.title = title;
        this.bytes = bytes;
        this.place = from;
        this.end = bytes.length;
        this.table = table;
    }

    /**
     * Those of a writer without a table.
     *
     * @param title what the bytes are, in messages
     * @param from where in {@code bytes} they begin; they end where {@code bytes} ends
     */
    public ByteItems(String title, byte[] bytes, int from) {
        this(title, bytes, from, null);
    }

    /** Those of a writer with a table. Messages say only what is wrong; the place and the remedy are up to the caller. */
    public static ByteItems withTable(byte[] bytes) {
        return new ByteItems("", bytes, 0, new ArrayList<>());
    }

    /** Goes to another part of the bytes. */
    public void goTo(int from, int length) {
        place = from;
        end = from + length;
    }

    @Override
    CodecException wrong(String what, String remedy) {
        return new CodecException(
                title.isEmpty() ? what : title + ", before byte " + place + ": " + what + "; " + remedy);
    }

    @Override
    CodecException damaged(String what) {
        return wrong(what, "the bytes are damaged, use another copy or start without it");
    }

    /**
     * Checks the version of a format.
     *
     * @throws CodecException if it is another than the one that is read
     */
    public void requireVersion(long found, long read) {
        if (found != read) {
            throw wrong(
                    "version " + found + " cannot be read, only version " + read,
                    "use the version of Evoloop that wrote it, or start without it");
        }
    }

    /** Reads the number of one of a few. */
    public <T> T oneOf(List<T> few) {
        long number = number();
        if (number < 0 || number >= few.size()) {
            throw damaged("one of " + few + " was expected, not " + number);
        }
        return few.get((int) number);
    }

    /** Reads one byte. */
    public int octet() {
        if (place >= end) {
            throw damaged("they end too early");
        }
        return bytes[place++] & 0xff;
    }

    private boolean isOne() {
        int octet = octet();
        if (octet > 1) {
            throw damaged("0 or 1 was expected, not " + octet);
        }
        return octet == 1;
    }

    @Override
    void next(String name) {}

    @Override
    String next() {
        return word();
    }

    @Override
    void ends() {}

    @Override
    public void endsAll() {
        if (place < end) {
            throw damaged("there is more after the end");
        }
    }

    @Override
    boolean isNone() {
        return !isOne();
    }

    @Override
    String word() {
        int code = octet();
        if (code == WordCodes.OTHER) {
            return text();
        } else if (!WordCodes.isKnown(code)) {
            throw damaged("there is no word " + code);
        }
        return WordCodes.word(code);
    }

    @Override
    boolean choice(String yes, String no) {
        return isOne();
    }

    @Override
    int choice(List<String> words) {
        int which = octet();
        if (which >= words.size()) {
            throw damaged("one of " + words + " was expected, not " + which);
        }
        return which;
    }

    @Override
    public long number() {
        long folded = unsigned();
        return (folded >>> 1) ^ -(folded & 1);
    }

    private long unsigned() {
        long number = 0;
        for (int shift = 0; shift < Long.SIZE; shift += ByteWriter.BITS) {
            int octet = octet();
            number |= (long) (octet & (ByteWriter.MORE - 1)) << shift;
            if (octet < ByteWriter.MORE) {
                return number;
            }
        }
        throw damaged("a number is too long");
    }

    @Override
    public String text() {
        long header = unsigned();
        boolean wide = (header & ByteWriter.WIDE) != 0;
        long count = header >>> 1;
        if (count > (end - place) / (wide ? 2 : 1)) {
            throw damaged("a text is longer than the rest");
        }
        return wide ? wide((int) count) : narrow((int) count);
    }

    @Override
    public String name() {
        if (table == null) {
            return text();
        }
        long number = number();
        if (number == table.size()) {
            table.add(text());
        } else if (number < 0 || number > table.size()) {
            throw damaged("a name has the number " + number + " of " + table.size());
        }
        return table.get((int) number);
    }

    @SuppressWarnings("deprecation") // It does not decode, which is right here: the core uses no charsets.
    private String narrow(int count) {
        String text = new String(bytes, 0, place, count);
        place += count;
        return text;
    }

    private String wide(int count) {
        char[] characters = new char[count];
        for (int at = 0; at < count; at++) {
            characters[at] = (char) ((octet() << Byte.SIZE) | octet());
        }
        return new String(characters);
    }

    @Override
    Object value() {
        int type = octet();
        if (type == ByteWriter.TEXT) {
            return text();
        } else if (type == ByteWriter.TRUE || type == ByteWriter.FALSE) {
            return type == ByteWriter.TRUE;
        } else if (type != ByteWriter.NUMBER) {
            throw damaged("there is no value of type " + type);
        }
        long bits = 0;
        for (int read = 0; read < Long.BYTES; read++) {
            bits = (bits << Byte.SIZE) | octet();
        }
        return Double.longBitsToDouble(bits);
    }
}
