package org.evoloop.fleet.wire;

import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.Collection;
import java.util.Map;
import org.jspecify.annotations.Nullable;

/**
 * Writes one JSON object as bytes, its members in the order of the calls, so that the same calls give the same bytes.
 */
final class Json {
    /** Large enough for nearly all records. */
    private static final int CAPACITY = 4096;

    /** Unused buffers; null while a record is being written. */
    private static final ThreadLocal<byte @Nullable []> SPARE = new ThreadLocal<>();

    private static final int DECIMAL = 10;
    private static final int DIGITS_OF_LONG = 19;
    private static final int ASCII = 0x80;
    private static final byte[] BEGIN = begin(Wire.SCHEMA);

    private byte[] bytes;
    private int length;

    /** A record. */
    Json() {
        this(BEGIN);
    }

    /** A record of this schema. */
    Json(int schema) {
        this(begin(schema));
    }

    private Json(byte[] begin) {
        byte[] spare = SPARE.get();
        bytes = spare == null ? new byte[CAPACITY] : spare;
        SPARE.set(null);
        length = begin.length;
        System.arraycopy(begin, 0, bytes, 0, length);
    }

    private static byte[] begin(int schema) {
        return ("{\"schema\":" + schema).getBytes(StandardCharsets.US_ASCII);
    }

    /** Begins an object in this one; {@link #end} ends it. */
    Json begin(String name) {
        name(name);
        return octet('{');
    }

    Json end() {
        return octet('}');
    }

    /** Names need no escapes, except those of {@link #withValues}. */
    @SuppressWarnings("deprecation") // It does not encode, which is right for ASCII, and fast.
    private Json name(String name) {
        int count = name.length();
        room(count + 4);
        if (bytes[length - 1] != '{') {
            bytes[length++] = ',';
        }
        bytes[length++] = '"';
        name.getBytes(0, count, bytes, length);
        length += count;
        bytes[length++] = '"';
        bytes[length++] = ':';
        return this;
    }

    private Json anyName(String name) {
        if (bytes[length - 1] != '{') {
            octet(',');
        }
        return quoted(name).octet(':');
    }

    Json with(String name, long value) {
        return name(name).number(value);
    }

    Json with(String name, double value) {
        return name(name).number(value);
    }

    Json with(String name, boolean value) {
        return name(name).plain(Boolean.toString(value));
    }

    Json with(String name, String value) {
        return name(name).quoted(value);
    }

    Json withText(String name, @Nullable String value) {
        return value == null || value.isEmpty() ? this : with(name, value);
    }

    Json with(String name, Collection<String> values) {
        name(name).octet('[');
        boolean first = true;
        for (String value : values) {
            if (!first) {
                octet(',');
            }
            quoted(value);
            first = false;
        }
        return octet(']');
    }

    /** Begins a list of objects; {@link #element} begins each, {@link #endList} ends the list. */
    Json beginList(String name) {
        return name(name).octet('[');
    }

    Json element() {
        if (bytes[length - 1] != '[') {
            octet(',');
        }
        return octet('{');
    }

    Json endList() {
        return octet(']');
    }

    /** Strings, numbers and booleans by any name. */
    Json withValues(String name, Map<String, ?> values) {
        if (values.isEmpty()) {
            return this;
        }
        begin(name);
        values.forEach((key, value) -> {
            anyName(key);
            if (value instanceof String words) {
                quoted(words);
            } else if (value instanceof Long number) {
                number(number);
            } else if (value instanceof Double number) {
                number(number);
            } else {
                plain(value.toString());
            }
        });
        return end();
    }

    private Json quoted(String words) {
        int count = words.length();
        room(count + 2);
        byte[] to = bytes;
        int next = length;
        to[next++] = '"';
        for (int at = 0; at < count; at++) {
            char each = words.charAt(at);
            if (each < ' ' || each == '"' || each == '\\' || each >= ASCII) {
                length = next;
                return rest(words, at).octet('"');
            }
            to[next++] = (byte) each;
        }
        to[next++] = '"';
        length = next;
        return this;
    }

    /** Writes the characters from {@code from} on, with escapes and in UTF-8. */
    private Json rest(String words, int from) {
        for (int at = from; at < words.length(); at++) {
            char each = words.charAt(at);
            if (each >= ASCII) {
                // The next char may be the second half of this character.
                other(words.substring(at));
                break;
            }
            ascii(each);
        }
        return this;
    }

    private void ascii(char each) {
        if (each == '"' || each == '\\') {
            octet('\\').octet(each);
        } else if (each < ' ') {
            escaped(each);
        } else {
            octet(each);
        }
    }

    private void escaped(char each) {
        plain(String.format("\\u%04x", (int) each));
    }

    /** UTF-8 cannot express half of a surrogate pair, which an escape in a record may have; it is written as one, too. */
    private void other(String words) {
        int at = 0;
        while (at < words.length()) {
            int point = words.codePointAt(at);
            if (point < ASCII) {
                ascii((char) point);
            } else if (point <= Character.MAX_VALUE && Character.isSurrogate((char) point)) {
                escaped((char) point);
            } else {
                utf8(point);
            }
            at += Character.charCount(point);
        }
    }

    private void utf8(int point) {
        for (byte each : Character.toString(point).getBytes(StandardCharsets.UTF_8)) {
            octet(each);
        }
    }

    /** JSON has no infinities and no NaN; they are written as strings, as in an exported journal. */
    private Json number(double value) {
        String text = Double.toString(value);
        return Double.isFinite(value) ? plain(text) : quoted(text);
    }

    private Json number(long value) {
        if (value < 0) {
            return plain(Long.toString(value));
        }
        int digits = 1;
        for (long power = DECIMAL; digits < DIGITS_OF_LONG && value >= power; power *= DECIMAL) {
            digits++;
        }
        room(digits);
        long rest = value;
        for (int at = length + digits - 1; at >= length; at--) {
            bytes[at] = (byte) ('0' + rest % DECIMAL);
            rest /= DECIMAL;
        }
        length += digits;
        return this;
    }

    private Json plain(String ascii) {
        room(ascii.length());
        for (int at = 0; at < ascii.length(); at++) {
            bytes[length++] = (byte) ascii.charAt(at);
        }
        return this;
    }

    private Json octet(int value) {
        room(1);
        bytes[length++] = (byte) value;
        return this;
    }

    private void room(int more) {
        if (length + more > bytes.length) {
            bytes = Arrays.copyOf(bytes, Math.max(2 * bytes.length, length + more));
        }
    }

    byte[] bytes() {
        octet('}');
        if (bytes.length == CAPACITY) {
            SPARE.set(bytes);
        }
        return Arrays.copyOf(bytes, length);
    }
}
