package org.evoloop.fleet.wire;

import java.nio.charset.StandardCharsets;
import java.util.Collection;
import java.util.Map;
import org.jspecify.annotations.Nullable;

/**
 * Writes one JSON object, its members in the order of the calls, so that equal content gives equal bytes.
 */
final class Json {
    private final StringBuilder text;

    /** A record. */
    Json() {
        this(new StringBuilder(160).append("{\"schema\":").append(Wire.SCHEMA));
    }

    private Json(StringBuilder text) {
        this.text = text;
    }

    /** An object inside a record. */
    static Json inner() {
        return new Json(new StringBuilder("{"));
    }

    private StringBuilder name(String name) {
        if (text.length() > 1) {
            text.append(',');
        }
        quoted(name);
        return text.append(':');
    }

    Json with(String name, long value) {
        name(name).append(value);
        return this;
    }

    Json with(String name, double value) {
        name(name).append(value);
        return this;
    }

    Json with(String name, boolean value) {
        name(name).append(value);
        return this;
    }

    Json with(String name, String value) {
        name(name);
        quoted(value);
        return this;
    }

    Json withText(String name, @Nullable String value) {
        return value == null || value.isEmpty() ? this : with(name, value);
    }

    Json with(String name, Json value) {
        name(name).append(value.text).append('}');
        return this;
    }

    Json with(String name, Collection<String> values) {
        name(name).append('[');
        String between = "";
        for (String value : values) {
            text.append(between);
            quoted(value);
            between = ",";
        }
        text.append(']');
        return this;
    }

    Json withObjects(String name, Collection<Json> values) {
        name(name).append('[');
        String between = "";
        for (Json value : values) {
            text.append(between).append(value.text).append('}');
            between = ",";
        }
        text.append(']');
        return this;
    }

    /** Strings, numbers and booleans by name. */
    Json withValues(String name, Map<String, Object> values) {
        if (values.isEmpty()) {
            return this;
        }
        Json inner = inner();
        values.forEach((key, value) -> {
            if (value instanceof String words) {
                inner.with(key, words);
            } else if (value instanceof Boolean truth) {
                inner.with(key, truth.booleanValue());
            } else if (value instanceof Double number) {
                inner.with(key, number.doubleValue());
            }
        });
        return with(name, inner);
    }

    private void quoted(String words) {
        text.append('"');
        if (isPlain(words)) {
            text.append(words);
        } else {
            escaped(words);
        }
        text.append('"');
    }

    private static boolean isPlain(String words) {
        for (int at = 0; at < words.length(); at++) {
            char each = words.charAt(at);
            if (each == '"' || each == '\\' || each < ' ') {
                return false;
            }
        }
        return true;
    }

    private void escaped(String words) {
        for (int at = 0; at < words.length(); at++) {
            char each = words.charAt(at);
            if (each == '"' || each == '\\') {
                text.append('\\').append(each);
            } else if (each < ' ') {
                text.append(String.format("\\u%04x", (int) each));
            } else {
                text.append(each);
            }
        }
    }

    byte[] bytes() {
        return text.append('}').toString().getBytes(StandardCharsets.UTF_8);
    }
}
