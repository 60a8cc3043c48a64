package org.evoloop.fleet.wire;

import java.nio.ByteBuffer;
import java.nio.charset.CharacterCodingException;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.HexFormat;
import java.util.List;

/**
 * Reads JSON strictly as RFC 8259 defines it. Every record is read, and most repeat the texts of earlier ones; a library's
 * parser, which makes each text again, took a fifth of a device's processor time. A value is a {@link String}, a {@link Long}, a {@link Double}, a {@link
 * Boolean}, a {@link List}, {@link Members}, or {@link Members#NULL}.
 */
final class JsonReader {
    /** How deep lists and objects may be nested; each level takes room on the stack. */
    private static final int DEEPEST = 100;

    /** This many digits always fit in a long. */
    private static final int DIGITS_OF_LONG = 18;

    private static final int DECIMAL = 10;
    private static final int HEX_DIGITS = 4;
    private static final int END = 0;
    private static final String ESCAPED = "\"\\/bfnrt";
    private static final String UNESCAPED = "\"\\/\b\f\n\r\t";

    /** Texts of earlier records by their hash, since most records consist of the same few. Threads may overwrite each other's. */
    private static final String[] KNOWN = new String[1 << 10];

    private static final int LONGEST_KNOWN = 32;

    private final byte[] bytes;
    private int place;
    private int depth;

    private JsonReader(byte[] bytes) {
        this.bytes = bytes;
    }

    /**
     * The value in {@code bytes}.
     *
     * @throws Refusal if they are something else, or there is more after it
     */
    static Object read(byte[] bytes) {
        JsonReader reader = new JsonReader(bytes);
        Object value = reader.value();
        if (reader.next() != END || reader.place < bytes.length) {
            throw reader.wrong("nothing was expected after it");
        }
        return value;
    }

    private Refusal wrong(String what) {
        return new Refusal(Refusal.Reason.MALFORMED, "it is not valid JSON: " + what + ", before byte " + place);
    }

    private int octet() {
        return place < bytes.length ? bytes[place] : END;
    }

    /** The next byte that is not white space; it is not passed yet. */
    private int next() {
        int octet = octet();
        while (octet == ' ' || octet == '\n' || octet == '\r' || octet == '\t') {
            place++;
            octet = octet();
        }
        return octet;
    }

    private boolean passes(char wanted) {
        boolean found = next() == wanted;
        if (found) {
            place++;
        }
        return found;
    }

    private void require(char wanted) {
        if (!passes(wanted)) {
            throw wrong("'" + wanted + "' was expected");
        }
    }

    private Object value() {
        return switch (next()) {
            case '{' -> members();
            case '[' -> list();
            case '"' -> string();
            case 't' -> literal("true", true);
            case 'f' -> literal("false", false);
            case 'n' -> literal("null", Members.NULL);
            default -> number();
        };
    }

    private Object literal(String word, Object value) {
        for (int at = 0; at < word.length(); at++) {
            if (octet() != word.charAt(at)) {
                throw wrong("'" + word + "' was expected");
            }
            place++;
        }
        return value;
    }

    private void descend() {
        place++;
        if (++depth > DEEPEST) {
            throw wrong("more than " + DEEPEST + " lists and objects are nested");
        }
    }

    private Members members() {
        descend();
        Members members = new Members();
        if (next() != '}') {
            do {
                if (next() != '"') {
                    throw wrong("a name was expected");
                }
                String name = string();
                require(':');
                members.add(name, value());
            } while (passes(','));
        }
        require('}');
        depth--;
        return members;
    }

    private List<Object> list() {
        descend();
        List<Object> list = new ArrayList<>();
        if (next() != ']') {
            do {
                list.add(value());
            } while (passes(','));
        }
        require(']');
        depth--;
        return list;
    }

    private Object number() {
        int from = place;
        if (octet() == '-') {
            place++;
        }
        int begun = place;
        long whole = digits();
        if (bytes[begun] == '0' && place > begun + 1) {
            throw wrong("a number begins with 0");
        }
        boolean isWhole = true;
        if (octet() == '.') {
            place++;
            digits();
            isWhole = false;
        }
        if (octet() == 'e' || octet() == 'E') {
            place++;
            if (octet() == '+' || octet() == '-') {
                place++;
            }
            digits();
            isWhole = false;
        }
        if (isWhole && place - begun <= DIGITS_OF_LONG) {
            return begun > from ? -whole : whole;
        }
        return longNumber(new String(bytes, from, place - from, StandardCharsets.ISO_8859_1), isWhole);
    }

    private static Object longNumber(String text, boolean isWhole) {
        try {
            return isWhole ? (Object) Long.valueOf(text) : (Object) Double.valueOf(text);
        } catch (NumberFormatException tooLarge) {
            return Double.valueOf(text);
        }
    }

    /** Passes at least one digit; returns their value unless it is too large. */
    private long digits() {
        long value = 0;
        int at = place;
        while (at < bytes.length && bytes[at] >= '0' && bytes[at] <= '9') {
            value = DECIMAL * value + bytes[at] - '0';
            at++;
        }
        if (at == place) {
            throw wrong("a value or a digit was expected");
        }
        place = at;
        return value;
    }

    private String string() {
        place++;
        int hash = 0;
        for (int at = place; at < bytes.length; at++) {
            int octet = bytes[at];
            if (octet == '"') {
                String text = ascii(place, at, hash);
                place = at + 1;
                return text;
            } else if (octet < ' ' || octet == '\\') {
                break;
            }
            hash = 31 * hash + octet;
        }
        return other(place);
    }

    /** @param hash that of the string */
    private String ascii(int from, int to, int hash) {
        int at = hash & (KNOWN.length - 1);
        String known = KNOWN[at];
        if (known != null && isSame(known, from, to)) {
            return known;
        }
        String text = new String(bytes, from, to - from, StandardCharsets.ISO_8859_1);
        if (text.length() <= LONGEST_KNOWN) {
            KNOWN[at] = text;
        }
        return text;
    }

    private boolean isSame(String text, int from, int to) {
        int length = to - from;
        if (text.length() != length) {
            return false;
        }
        for (int at = 0; at < length; at++) {
            if (text.charAt(at) != bytes[from + at]) {
                return false;
            }
        }
        return true;
    }

    /** A string with escapes, or with characters that are not ASCII. */
    private String other(int from) {
        for (int octet = octet(); octet != '"'; octet = octet()) {
            if (octet >= 0 && octet < ' ') {
                throw wrong("a string does not end, or contains a control character");
            }
            place += octet == '\\' ? 2 : 1;
        }
        String text;
        try {
            text = StandardCharsets.UTF_8
                    .newDecoder()
                    .decode(ByteBuffer.wrap(bytes, from, place - from))
                    .toString();
        } catch (CharacterCodingException e) {
            throw wrong("a string is not UTF-8");
        }
        place++;
        return text.indexOf('\\') < 0 ? text : unescaped(text);
    }

    private String unescaped(String text) {
        StringBuilder plain = new StringBuilder(text.length());
        for (int at = 0; at < text.length(); at++) {
            char each = text.charAt(at);
            if (each == '\\') {
                at++;
                int known = ESCAPED.indexOf(text.charAt(at));
                if (known >= 0) {
                    each = UNESCAPED.charAt(known);
                } else if (text.charAt(at) == 'u') {
                    each = character(text, at + 1);
                    at += HEX_DIGITS;
                } else {
                    throw wrong("a string contains an unknown escape");
                }
            }
            plain.append(each);
        }
        return plain.toString();
    }

    private char character(String text, int at) {
        try {
            return (char) HexFormat.fromHexDigits(text, at, at + HEX_DIGITS);
        } catch (IllegalArgumentException | IndexOutOfBoundsException e) {
            throw wrong("a character is not given by four digits");
        }
    }
}
