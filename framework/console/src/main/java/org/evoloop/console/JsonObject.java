package org.evoloop.console;

import java.util.Collection;
import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.evoloop.function.Reading;
import org.jspecify.annotations.Nullable;

/**
 * Builds a JSON object; its text is one line of ASCII. Members are in the order in which they were put.
 *
 * <p>Threading: not thread-safe.
 *
 * @since 0.1
 */
public final class JsonObject {
    private final StringBuilder members = new StringBuilder();

    /** An object without members. */
    public JsonObject() {}

    /** A member for each reading, by its name; its value without its unit. */
    public static JsonObject of(List<Reading> readings) {
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

    /**
     * Puts a text.
     *
     * @param value null is written as such
     */
    public JsonObject put(String key, @Nullable String value) {
        return putText(key, value == null ? "null" : quote(value));
    }

    /** Puts a number. */
    public JsonObject put(String key, long value) {
        return putText(key, Long.toString(value));
    }

    /** Puts a finite number. */
    public JsonObject put(String key, double value) {
        return putText(key, Double.toString(value));
    }

    /** Puts true or false. */
    public JsonObject put(String key, boolean value) {
        return putText(key, Boolean.toString(value));
    }

    /**
     * Puts an object.
     *
     * @param value null is written as such
     */
    public JsonObject put(String key, @Nullable JsonObject value) {
        return putText(key, String.valueOf(value));
    }

    /** Puts an array of objects. */
    public JsonObject put(String key, List<JsonObject> values) {
        return putArray(key, values.stream().map(JsonObject::toString));
    }

    /** Puts an array of strings. */
    public JsonObject putTexts(String key, Collection<String> values) {
        return putArray(key, values.stream().map(JsonObject::quote));
    }

    private JsonObject putArray(String key, Stream<String> json) {
        return putText(key, json.collect(Collectors.joining(",", "[", "]")));
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
                // ASCII is safe in every output encoding.
                quoted.append(String.format("\\u%04x", (int) next));
            }
        }
        return quoted.append('"').toString();
    }

    /** The object as one line. */
    @Override
    public String toString() {
        return "{" + members + "}";
    }
}
