package org.evoloop.console;

import java.util.List;
import org.evoloop.function.Reading;
import org.jspecify.annotations.Nullable;

/**
 * A JSON object in the making; its text is one line.
 *
 * <p>Threading: not thread-safe.
 */
final class JsonObject {
    private final StringBuilder members = new StringBuilder();

    /** A member for each reading, by its name; its value without its unit. */
    static JsonObject of(List<Reading> readings) {
        JsonObject members = new JsonObject();
        for (Reading reading : readings) {
            if (reading.value() instanceof String text) {
                members.put(reading.name(), text);
            } else {
                members.putText(reading.name(), reading.value().toString());
            }
        }
        return members;
    }

    JsonObject put(String key, @Nullable String value) {
        return putText(key, value == null ? "null" : quote(value));
    }

    JsonObject put(String key, long value) {
        return putText(key, Long.toString(value));
    }

    JsonObject put(String key, boolean value) {
        return putText(key, Boolean.toString(value));
    }

    /** @param value null is written as such */
    JsonObject put(String key, @Nullable JsonObject value) {
        return putText(key, String.valueOf(value));
    }

    JsonObject put(String key, List<JsonObject> values) {
        return putText(
                key,
                "[" + String.join(",", values.stream().map(JsonObject::toString).toList()) + "]");
    }

    private JsonObject putText(String key, String json) {
        members.append(members.length() == 0 ? "" : ",")
                .append(quote(key))
                .append(':')
                .append(json);
        return this;
    }

    private static String quote(String text) {
        StringBuilder quoted = new StringBuilder("\"");
        for (int i = 0; i < text.length(); i++) {
            char next = text.charAt(i);
            if (next == '"' || next == '\\') {
                quoted.append('\\').append(next);
            } else if (next >= ' ' && next <= '~') {
                quoted.append(next);
            } else {
                // Whatever the encoding of the output, ASCII survives it.
                quoted.append(String.format("\\u%04x", (int) next));
            }
        }
        return quoted.append('"').toString();
    }

    @Override
    public String toString() {
        return "{" + members + "}";
    }
}
