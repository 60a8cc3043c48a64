package org.evoloop.fleet.wire;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.function.BiConsumer;
import org.jspecify.annotations.Nullable;
import tools.jackson.core.JacksonException;
import tools.jackson.core.JsonParser;
import tools.jackson.core.JsonToken;
import tools.jackson.core.ObjectReadContext;
import tools.jackson.core.json.JsonFactory;
import tools.jackson.core.util.JsonRecyclerPools;

/**
 * The members of a JSON object, in two arrays: records have few, and a tree of nodes takes several times as long to build.
 * A value is a {@link String}, a {@link Long}, a {@link Double}, a {@link Boolean}, a {@link List}, another object's {@code
 * Members}, or {@link #NULL}.
 */
final class Members {
    static final Object NULL = new Object();

    private static final int FEW = 8;
    private static final JsonFactory FACTORY = JsonFactory.builder()
            .recyclerPool(JsonRecyclerPools.threadLocalPool())
            .build();

    private String[] names = new String[FEW];
    private Object[] values = new Object[FEW];
    private int count;

    private Members() {}

    /**
     * Reads an object.
     *
     * @return null if it is something else
     * @throws JacksonException if it is not valid JSON, or there is more after it
     */
    static @Nullable Members read(byte[] bytes) {
        try (JsonParser parser = FACTORY.createParser(ObjectReadContext.empty(), bytes)) {
            JsonToken first = parser.nextToken();
            Object value = first == null ? NULL : value(parser, first);
            if (first != null && parser.nextToken() != null) {
                return null;
            }
            return value instanceof Members members ? members : null;
        }
    }

    private static Object value(JsonParser parser, JsonToken token) {
        return switch (token) {
            case START_OBJECT -> members(parser);
            case START_ARRAY -> list(parser);
            case VALUE_STRING -> parser.getString();
            case VALUE_NUMBER_INT ->
                // Too large for a long, so it is not read as a whole number either.
                parser.getNumberType() == JsonParser.NumberType.BIG_INTEGER
                        ? (Object) parser.getDoubleValue()
                        : (Object) parser.getLongValue();
            case VALUE_NUMBER_FLOAT -> parser.getDoubleValue();
            case VALUE_TRUE -> true;
            case VALUE_FALSE -> false;
            default -> NULL;
        };
    }

    private static Members members(JsonParser parser) {
        Members members = new Members();
        for (String name = parser.nextName(); name != null; name = parser.nextName()) {
            members.add(name, value(parser, parser.nextToken()));
        }
        return members;
    }

    private static List<Object> list(JsonParser parser) {
        List<Object> list = new ArrayList<>();
        for (JsonToken next = parser.nextToken(); next != JsonToken.END_ARRAY; next = parser.nextToken()) {
            list.add(value(parser, next));
        }
        return list;
    }

    private void add(String name, Object value) {
        if (count == names.length) {
            names = Arrays.copyOf(names, 2 * count);
            values = Arrays.copyOf(values, 2 * count);
        }
        names[count] = name;
        values[count++] = value;
    }

    /** The last value of that name; null if there is none. */
    @Nullable
    Object get(String name) {
        for (int at = count - 1; at >= 0; at--) {
            if (names[at].equals(name)) {
                return values[at];
            }
        }
        return null;
    }

    void forEach(BiConsumer<String, Object> each) {
        for (int at = 0; at < count; at++) {
            each.accept(names[at], values[at]);
        }
    }
}
