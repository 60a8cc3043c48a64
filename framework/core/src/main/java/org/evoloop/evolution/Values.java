package org.evoloop.evolution;

import static java.util.Objects.requireNonNull;

import java.util.Collections;
import java.util.Map;
import java.util.TreeMap;
import org.jspecify.annotations.Nullable;

/**
 * The values that an event carries, such as a temperature or a time of day: strings, numbers and booleans by name.
 *
 * <p>Threading: immutable.
 *
 * @param byName the values in the order of their names; each a {@link String}, {@link Double} or {@link Boolean}
 * @since 0.1
 */
public record Values(Map<String, Object> byName) {
    /** No values. */
    public static final Values NONE = new Values(Map.of());

    /** The largest number of values of an event. */
    public static final int MOST = 64;

    private static final String NO_NAME = "the name of a value is null";

    /** The largest total length of names and strings, in characters. */
    public static final int MOST_CHARACTERS = 16_384;

    /**
     * Values are bounded, since events are queued, remembered and recorded in journals.
     *
     * @throws NullPointerException if {@code byName} or a name in it is null
     * @throws IllegalArgumentException if a value is neither a string, a number nor a boolean, or there are more than
     *     {@value #MOST}, or they are longer than {@value #MOST_CHARACTERS} characters in all
     */
    public Values {
        requireFew(requireNonNull(byName, "the values are null; Values.NONE are none"));
        TreeMap<String, Object> sorted = new TreeMap<>();
        byName.forEach((name, value) -> sorted.put(name, plain(name, value)));
        byName = sorted.isEmpty() ? Map.of() : Collections.unmodifiableMap(sorted);
    }

    private static void requireFew(Map<String, Object> byName) {
        if (byName.size() > MOST) {
            throw new IllegalArgumentException(
                    "an event cannot carry " + byName.size() + " values; at most " + MOST + " are allowed");
        }
        long characters = 0;
        for (Map.Entry<String, Object> each : byName.entrySet()) {
            characters += requireNonNull(each.getKey(), NO_NAME).length()
                    + (each.getValue() instanceof String text ? text.length() : 0);
        }
        if (characters > MOST_CHARACTERS) {
            throw new IllegalArgumentException("the values of an event have " + characters + " characters, at most "
                    + MOST_CHARACTERS + " are allowed; send a reference instead");
        }
    }

    private static Object plain(String name, @Nullable Object value) {
        if (value instanceof Number number) {
            return number.doubleValue();
        }
        if (value instanceof String || value instanceof Boolean) {
            return value;
        }
        throw new IllegalArgumentException("the value " + name + " is "
                + (value == null ? "null" : "a " + value.getClass().getSimpleName())
                + "; allowed are texts, numbers and true or false");
    }

    /**
     * One value.
     *
     * @throws IllegalArgumentException if it is neither a string, a number nor a boolean
     */
    public static Values of(String name, Object value) {
        return NONE.with(name, value);
    }

    /**
     * A copy with this value added or replaced.
     *
     * @throws IllegalArgumentException as the constructor
     */
    public Values with(String name, Object value) {
        TreeMap<String, Object> more = new TreeMap<>(byName);
        more.put(requireNonNull(name, NO_NAME), value);
        return new Values(more);
    }

    /** Whether there are none. */
    public boolean isEmpty() {
        return byName.isEmpty();
    }

    /**
     * A number.
     *
     * @throws IllegalArgumentException if there is no number of that name
     */
    public double number(String name) {
        return require(name, Double.class);
    }

    /**
     * A string.
     *
     * @throws IllegalArgumentException if there is no string of that name
     */
    public String text(String name) {
        return require(name, String.class);
    }

    /**
     * A boolean.
     *
     * @throws IllegalArgumentException if there is no boolean of that name
     */
    public boolean truth(String name) {
        return require(name, Boolean.class);
    }

    /**
     * A number, or {@code otherwise} if there is nothing of that name.
     *
     * @throws IllegalArgumentException if it is something else
     */
    public double number(String name, double otherwise) {
        return byName.containsKey(requireNonNull(name, NO_NAME)) ? number(name) : otherwise;
    }

    /**
     * A string, or {@code otherwise} if there is nothing of that name.
     *
     * @throws IllegalArgumentException if it is something else
     */
    public String text(String name, String otherwise) {
        return byName.containsKey(requireNonNull(name, NO_NAME)) ? text(name) : otherwise;
    }

    /**
     * A boolean, or {@code otherwise} if there is nothing of that name.
     *
     * @throws IllegalArgumentException if it is something else
     */
    public boolean truth(String name, boolean otherwise) {
        return byName.containsKey(requireNonNull(name, NO_NAME)) ? truth(name) : otherwise;
    }

    private <T> T require(String name, Class<T> type) {
        Object value = byName.get(requireNonNull(name, NO_NAME));
        if (!type.isInstance(value)) {
            throw new IllegalArgumentException(
                    "there is no " + type.getSimpleName() + " named " + name + " in " + this);
        }
        return type.cast(value);
    }

    /** For messages: {@code temperature=21.5, room=kitchen}. */
    @Override
    public String toString() {
        StringBuilder text = new StringBuilder();
        byName.forEach((name, value) ->
                text.append(text.isEmpty() ? "" : ", ").append(name).append('=').append(shown(value)));
        return text.toString();
    }

    /** Whole numbers without a fraction. */
    private static String shown(Object value) {
        boolean whole = value instanceof Double number && number == Math.rint(number) && Math.abs(number) < 1e15;
        return whole ? String.valueOf(((Double) value).longValue()) : value.toString();
    }
}
