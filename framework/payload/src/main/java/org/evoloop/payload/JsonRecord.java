package org.evoloop.payload;

import java.util.ArrayList;
import java.util.Collection;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.Function;
import org.evoloop.evolution.Values;
import org.jspecify.annotations.Nullable;
import tools.jackson.core.JacksonException;
import tools.jackson.core.JsonParser;
import tools.jackson.core.JsonParser.NumberType;
import tools.jackson.core.JsonToken;
import tools.jackson.core.ObjectReadContext;
import tools.jackson.core.StreamReadConstraints;
import tools.jackson.core.TokenStreamFactory;
import tools.jackson.core.exc.StreamConstraintsException;
import tools.jackson.core.json.JsonFactory;

/**
 * A JSON object (RFC 8259) that was read, as a record of named members. The last of two members of a name counts.
 *
 * <p>Errors: what cannot be read, and a member that is missing or of another kind, is the exception that was given for
 * this; it names the member or the place, and what was expected.
 *
 * <p>Threading: immutable.
 *
 * @since 0.1
 */
public final class JsonRecord {
    /** How deep lists and objects may be nested; each level takes room on the stack. */
    static final int DEEPEST = 100;

    private static final JsonFactory JSON = JsonFactory.builder()
            .streamReadConstraints(
                    StreamReadConstraints.builder().maxNestingDepth(DEEPEST).build())
            // Bytes are UTF-8.
            .disable(TokenStreamFactory.Feature.CHARSET_DETECTION)
            .build();

    /** Whole doubles of a smaller magnitude fit in a long. */
    private static final double MOST_WHOLE = 0x1p63;

    private final Map<String, @Nullable Object> members;
    private final Function<String, ? extends RuntimeException> malformed;

    private JsonRecord(Map<String, @Nullable Object> members, Function<String, ? extends RuntimeException> malformed) {
        this.members = members;
        this.malformed = malformed;
    }

    /**
     * Parses a text.
     *
     * @throws IllegalArgumentException if it is not a JSON object, as for everything that is wrong with its members
     */
    public static JsonRecord of(String text) {
        return read(JSON.createParser(ObjectReadContext.empty(), text), IllegalArgumentException::new);
    }

    /**
     * Parses bytes.
     *
     * @param utf8 the object
     * @param malformed makes the exception, from the problem in words
     */
    public static JsonRecord of(byte[] utf8, Function<String, ? extends RuntimeException> malformed) {
        return read(JSON.createParser(ObjectReadContext.empty(), utf8), malformed);
    }

    private static JsonRecord read(JsonParser text, Function<String, ? extends RuntimeException> malformed) {
        try (JsonParser json = text) {
            if (json.nextToken() != JsonToken.START_OBJECT) {
                throw malformed.apply("a JSON object was expected");
            }
            JsonRecord read = new JsonRecord(new LinkedHashMap<>(), malformed);
            read.readMembers(json, read.members);
            if (json.nextToken() != null) {
                throw malformed.apply("it is not valid JSON: there is more after the object");
            }
            return read;
        } catch (StreamConstraintsException e) {
            throw malformed.apply("it is not valid JSON: more than " + DEEPEST
                    + " lists and objects are nested, or a name, a text or a number is too long");
        } catch (JacksonException e) {
            throw malformed.apply(
                    "it is not valid JSON: line " + e.getLocation().getLineNr() + ", column "
                            + e.getLocation().getColumnNr() + ": " + e.getOriginalMessage());
        }
    }

    private void readMembers(JsonParser json, Map<String, @Nullable Object> into) {
        while (json.nextToken() != JsonToken.END_OBJECT) {
            String name = json.currentName();
            json.nextToken();
            into.put(name, value(json, name));
        }
    }

    private @Nullable Object value(JsonParser json, String name) {
        switch (json.currentToken()) {
            case START_OBJECT -> {
                Map<String, @Nullable Object> object = new LinkedHashMap<>();
                readMembers(json, object);
                return object;
            }
            case START_ARRAY -> {
                List<@Nullable Object> list = new ArrayList<>();
                while (json.nextToken() != JsonToken.END_ARRAY) {
                    list.add(value(json, name));
                }
                return list;
            }
            case VALUE_NUMBER_INT, VALUE_NUMBER_FLOAT -> {
                return number(json, name);
            }
            case VALUE_TRUE, VALUE_FALSE -> {
                return json.getBooleanValue();
            }
            case VALUE_NULL -> {
                return null;
            }
            default -> {
                return json.getString();
            }
        }
    }

    /** JSON cannot express an infinity, so a record with one could not be written again. */
    private Number number(JsonParser json, String name) {
        NumberType type = json.getNumberType();
        if (type == NumberType.INT || type == NumberType.LONG) {
            return json.getLongValue();
        }
        double number = json.getDoubleValue();
        if (Double.isInfinite(number)) {
            throw malformed.apply("the number '" + name + "' is too large; send one of at most 1.7E308, or a string");
        }
        return number;
    }

    /** A copy to be written, with more members. */
    public JsonObject copy() {
        return new JsonObject(members);
    }

    /** The names of all members, in their order. */
    public Set<String> names() {
        return Collections.unmodifiableSet(members.keySet());
    }

    /** A copy with the members of another one, which count, and without those of these names. */
    public JsonRecord with(JsonRecord more, Collection<String> without) {
        Map<String, @Nullable Object> all = new LinkedHashMap<>(members);
        all.keySet().removeAll(without);
        all.putAll(more.members);
        return new JsonRecord(all, malformed);
    }

    /** Whether there is a member of that name, possibly null. */
    public boolean has(String name) {
        return members.containsKey(name);
    }

    /** The whole number of that name. */
    public long number(String name) {
        Object value = members.get(name);
        if (value instanceof Long number) {
            return number;
        } else if (value instanceof Double number && number == Math.rint(number) && Math.abs(number) < MOST_WHOLE) {
            return number.longValue();
        }
        throw malformed.apply("'" + name + "' must be a whole number");
    }

    /** The whole number of that name; {@code otherwise} if there is none. */
    public long number(String name, long otherwise) {
        return has(name) ? number(name) : otherwise;
    }

    /** The number of that name, possibly with a fraction; {@code otherwise} if there is none. */
    public double fraction(String name, double otherwise) {
        if (!has(name)) {
            return otherwise;
        } else if (members.get(name) instanceof Number number) {
            return number.doubleValue();
        }
        throw malformed.apply("'" + name + "' must be a number");
    }

    /** The text of that name. */
    public String text(String name) {
        if (members.get(name) instanceof String text) {
            return text;
        }
        throw malformed.apply("'" + name + "' must be a string");
    }

    /** The text of that name; {@code otherwise} if there is none. */
    public String text(String name, String otherwise) {
        return has(name) ? text(name) : otherwise;
    }

    /** The truth of that name; false if there is none. */
    public boolean truth(String name) {
        if (!has(name)) {
            return false;
        } else if (members.get(name) instanceof Boolean truth) {
            return truth;
        }
        throw malformed.apply("'" + name + "' must be true or false");
    }

    /** The texts of that name, a list; none if there is no such list. */
    public List<String> texts(String name) {
        List<String> texts = new ArrayList<>();
        for (Object value : list(name)) {
            if (!(value instanceof String text)) {
                throw malformed.apply("'" + name + "' must be a list of strings");
            }
            texts.add(text);
        }
        return texts;
    }

    /** The objects of that name, a list; none if there is no such list. */
    public List<JsonRecord> each(String name) {
        List<JsonRecord> each = new ArrayList<>();
        for (Object value : list(name)) {
            if (!(value instanceof Map<?, ?> object)) {
                throw malformed.apply("'" + name + "' must be a list of objects");
            }
            each.add(inner(object));
        }
        return each;
    }

    private List<?> list(String name) {
        Object value = members.get(name);
        if (value == null) {
            return List.of();
        } else if (value instanceof List<?> list) {
            return list;
        }
        throw malformed.apply("'" + name + "' must be a list");
    }

    /** The object of that name. */
    public Optional<JsonRecord> inner(String name) {
        Object value = members.get(name);
        if (value == null) {
            return Optional.empty();
        } else if (value instanceof Map<?, ?> object) {
            return Optional.of(inner(object));
        }
        throw malformed.apply("'" + name + "' must be an object");
    }

    @SuppressWarnings("unchecked") // this class has made all maps
    private JsonRecord inner(Map<?, ?> object) {
        return new JsonRecord((Map<String, @Nullable Object>) object, malformed);
    }

    /** The values of an event, an object of that name; none if there is no such object. */
    @SuppressWarnings("NullAway") // which value is null is said by Values
    public Values values(String name) {
        Optional<JsonRecord> values = inner(name);
        try {
            return values.isEmpty() ? Values.NONE : new Values(values.get().members);
        } catch (IllegalArgumentException e) {
            throw malformed.apply(String.valueOf(e.getMessage()));
        }
    }
}
