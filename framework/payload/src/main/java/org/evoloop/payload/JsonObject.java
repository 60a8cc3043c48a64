package org.evoloop.payload;

import java.nio.charset.StandardCharsets;
import java.util.Collection;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.evoloop.function.Reading;
import org.jspecify.annotations.Nullable;
import tools.jackson.core.JsonGenerator;
import tools.jackson.core.ObjectWriteContext;
import tools.jackson.core.io.SegmentedStringWriter;
import tools.jackson.core.json.JsonFactory;
import tools.jackson.core.json.JsonWriteFeature;
import tools.jackson.core.util.BufferRecycler;

/**
 * A JSON object to be written; its text is one line of ASCII. Members are in the order in which they were first put; the
 * last value put counts. JSON has no infinities and no NaN; they are written as strings.
 *
 * <p>Threading: not thread-safe.
 *
 * @since 0.1
 */
public final class JsonObject {
    /** ASCII is safe in every output encoding, and half of a surrogate pair can be written, too. */
    private static final JsonFactory JSON =
            JsonFactory.builder().enable(JsonWriteFeature.ESCAPE_NON_ASCII).build();

    private static final ClassValue<Map<Enum<?>, String>> WORDS = new ClassValue<>() {
        @Override
        protected Map<Enum<?>, String> computeValue(Class<?> type) {
            return Stream.of(type.getEnumConstants())
                    .map(each -> (Enum<?>) each)
                    .collect(Collectors.toMap(
                            each -> each,
                            each -> each.name().toLowerCase(Locale.ROOT).replace('_', '-')));
        }
    };

    private final Map<String, @Nullable Object> members;

    /** An object without members. */
    public JsonObject() {
        this(Map.of());
    }

    /** An object with these members: texts, numbers, truths, nulls, and lists and maps of them. */
    JsonObject(Map<String, ? extends @Nullable Object> members) {
        this.members = new LinkedHashMap<>(members);
    }

    /** A member for each reading, by its name; its value without its unit. */
    public static JsonObject of(List<Reading> readings) {
        JsonObject object = new JsonObject();
        readings.forEach(reading -> object.members.put(reading.name(), reading.value()));
        return object;
    }

    /**
     * Puts a text.
     *
     * @param value null is written as such
     */
    public JsonObject put(String key, @Nullable String value) {
        return putAny(key, value);
    }

    /** Puts a number. */
    public JsonObject put(String key, long value) {
        return putAny(key, value);
    }

    /** Puts a number. */
    public JsonObject put(String key, double value) {
        return putAny(key, value);
    }

    /** Puts true or false. */
    public JsonObject put(String key, boolean value) {
        return putAny(key, value);
    }

    /**
     * Puts an object.
     *
     * @param value null is written as such
     */
    public JsonObject put(String key, @Nullable JsonObject value) {
        return putAny(key, value == null ? null : value.members);
    }

    /** Puts an array of objects. */
    public JsonObject put(String key, List<JsonObject> values) {
        return putAny(key, values.stream().map(each -> each.members).toList());
    }

    /** Puts an array of strings. */
    public JsonObject putTexts(String key, Collection<String> values) {
        return putAny(key, List.copyOf(values));
    }

    /** Puts a text unless it is empty. */
    public JsonObject putSome(String key, String value) {
        return value.isEmpty() ? this : put(key, value);
    }

    /** Puts an object of values, each a {@link String}, a {@link Number} or a {@link Boolean}, unless there are none. */
    public JsonObject putSome(String key, Map<String, ?> values) {
        return values.isEmpty() ? this : putAny(key, values);
    }

    private JsonObject putAny(String key, @Nullable Object value) {
        members.put(key, value);
        return this;
    }

    /** How a constant is called in JSON: {@code in-doubt} for {@code IN_DOUBT}. */
    public static String word(Enum<?> constant) {
        return WORDS.get(constant.getDeclaringClass()).getOrDefault(constant, "");
    }

    private static void write(JsonGenerator json, @Nullable Object value) {
        if (value instanceof String text) {
            json.writeString(text);
        } else if (value instanceof Long number) {
            json.writeNumber(number);
        } else if (value instanceof Number number) {
            json.writeNumber(number.doubleValue());
        } else if (value instanceof Boolean truth) {
            json.writeBoolean(truth);
        } else if (value instanceof Map<?, ?> object) {
            json.writeStartObject();
            object.forEach((name, member) -> {
                json.writeName((String) name);
                write(json, member);
            });
            json.writeEndObject();
        } else if (value instanceof List<?> array) {
            json.writeStartArray();
            array.forEach(each -> write(json, each));
            json.writeEndArray();
        } else {
            json.writeNull();
        }
    }

    /** The object as one line. */
    @Override
    public String toString() {
        SegmentedStringWriter text = new SegmentedStringWriter(new BufferRecycler());
        try (JsonGenerator json = JSON.createGenerator(ObjectWriteContext.empty(), text)) {
            write(json, members);
        }
        return text.getAndClear();
    }

    /** The bytes of the line. */
    public byte[] toBytes() {
        return toString().getBytes(StandardCharsets.US_ASCII);
    }
}
