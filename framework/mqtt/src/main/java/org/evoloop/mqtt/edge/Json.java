package org.evoloop.mqtt.edge;

import java.util.ArrayList;
import java.util.HexFormat;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.regex.Pattern;
import org.jspecify.annotations.Nullable;

/** Reads JSON: objects as maps, arrays as lists, numbers as {@link Double}, which are finite. */
final class Json {
    private static final int DEEPEST = 20;
    private static final Pattern NUMBER = Pattern.compile("-?(0|[1-9][0-9]*)(\\.[0-9]+)?([eE][+-]?[0-9]+)?");

    private final String text;
    private int at;
    private int depth;

    private Json(String text) {
        this.text = text;
    }

    /**
     * Parses {@code text} as an object.
     *
     * @throws IllegalArgumentException if it is not one
     */
    static Map<String, @Nullable Object> object(String text) {
        Json json = new Json(text);
        json.expect('{');
        Map<String, @Nullable Object> object = json.members();
        json.space();
        if (json.at < text.length()) {
            throw json.wrong("there is more after the object");
        }
        return object;
    }

    private @Nullable Object value() {
        space();
        if (++depth > DEEPEST) {
            throw wrong("it is nested too deeply");
        }
        char first = at < text.length() ? text.charAt(at) : ' ';
        Object value;
        if (first == '{') {
            at++;
            value = members();
        } else if (first == '[') {
            at++;
            value = elements();
        } else if (first == '"') {
            at++;
            value = string();
        } else {
            value = word();
        }
        depth--;
        return value;
    }

    private Map<String, @Nullable Object> members() {
        Map<String, @Nullable Object> members = new LinkedHashMap<>();
        if (takes('}')) {
            return members;
        }
        do {
            expect('"');
            String name = string();
            expect(':');
            members.put(name, value());
        } while (takes(','));
        expect('}');
        return members;
    }

    private List<@Nullable Object> elements() {
        List<@Nullable Object> elements = new ArrayList<>();
        if (takes(']')) {
            return elements;
        }
        do {
            elements.add(value());
        } while (takes(','));
        expect(']');
        return elements;
    }

    private String string() {
        StringBuilder words = new StringBuilder();
        while (at < text.length()) {
            char next = text.charAt(at++);
            if (next == '"') {
                return words.toString();
            }
            words.append(next == '\\' ? escaped() : next);
        }
        throw wrong("a string has no closing quotation mark");
    }

    private char escaped() {
        char which = at < text.length() ? text.charAt(at++) : ' ';
        int plain = "nrtbf\"\\/".indexOf(which);
        if (plain >= 0) {
            return "\n\r\t\b\f\"\\/".charAt(plain);
        } else if (which == 'u' && at + 4 <= text.length()) {
            at += 4;
            return hexadecimal(text.substring(at - 4, at));
        }
        throw wrong("\\" + which + " is not an escape sequence");
    }

    private char hexadecimal(String digits) {
        if (!digits.chars().allMatch(HexFormat::isHexDigit)) {
            throw wrong("\\u" + digits + " is not an escape sequence");
        }
        return (char) HexFormat.fromHexDigits(digits);
    }

    private @Nullable Object word() {
        int begin = at;
        while (at < text.length() && ",]} \t\r\n".indexOf(text.charAt(at)) < 0) {
            at++;
        }
        String word = text.substring(begin, at);
        return switch (word) {
            case "true" -> true;
            case "false" -> false;
            case "null" -> null;
            default -> number(word);
        };
    }

    /** Java's own parser accepts more, such as NaN, 1d and 0x1p3. */
    private Double number(String word) {
        if (!NUMBER.matcher(word).matches()) {
            throw wrong("'" + word + "' is not a value");
        }
        double number = Double.parseDouble(word);
        if (Double.isInfinite(number)) {
            throw new IllegalArgumentException("the number " + word + " before character " + at
                    + " is too large; send one of at most 1.7E308, or a string");
        }
        return number;
    }

    private boolean takes(char wanted) {
        space();
        boolean there = at < text.length() && text.charAt(at) == wanted;
        at += there ? 1 : 0;
        return there;
    }

    private void expect(char wanted) {
        if (!takes(wanted)) {
            throw wrong("'" + wanted + "' is missing");
        }
    }

    private void space() {
        while (at < text.length() && Character.isWhitespace(text.charAt(at))) {
            at++;
        }
    }

    private IllegalArgumentException wrong(String what) {
        return new IllegalArgumentException("this is not valid JSON: " + what + " at character " + at);
    }
}
