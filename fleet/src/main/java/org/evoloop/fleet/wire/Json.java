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
    /** Large enough for most records. */
    private static final int CAPACITY = 256;

    private static final int DECIMAL = 10;
    private static final int ASCII = 0x80;
    private static final byte[] BEGIN = ("{\"schema\":" + Wire.SCHEMA).getBytes(StandardCharsets.US_ASCII);

    private byte[] bytes;
    private int length;

    /** A record. */
    Json() {
        bytes = Arrays.copyOf(BEGIN, CAPACITY);
        length = BEGIN.length;
    }

    /** Begins an object in this one; {@link #end} ends it. */
    Json begin(String name) {
        name(name);
        return octet('{');
    }

    Json end() {
        return octet('}');
    }

    private Json name(String name) {
        if (bytes[length - 1] != '{') {
            octet(',');
        }
        return quoted(name).octet(':');
    }

    Json with(String name, long value) {
        return name(name).number(value);
    }

    Json with(String name, double value) {
        return name(name).plain(Double.toString(value));
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

    /** Strings, numbers and booleans by name. */
    Json withValues(String name, Map<String, Object> values) {
        if (values.isEmpty()) {
            return this;
        }
        begin(name);
        values.forEach((key, value) -> {
            if (value instanceof String words) {
                with(key, words);
            } else if (value instanceof Boolean truth) {
                with(key, truth.booleanValue());
            } else if (value instanceof Double number) {
                with(key, number.doubleValue());
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
            plain(String.format("\\u%04x", (int) each));
        } else {
            octet(each);
        }
    }

    private void other(String words) {
        for (byte each : words.getBytes(StandardCharsets.UTF_8)) {
            if (each < 0) {
                octet(each);
            } else {
                ascii((char) each);
            }
        }
    }

    private Json number(long value) {
        if (value < 0) {
            return plain(Long.toString(value));
        }
        int digits = 1;
        for (long rest = value / DECIMAL; rest > 0; rest /= DECIMAL) {
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
        return Arrays.copyOf(bytes, length);
    }
}
