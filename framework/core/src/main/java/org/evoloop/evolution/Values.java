package org.evoloop.evolution;

import java.util.Collections;
import java.util.Map;
import java.util.TreeMap;

/**
 * What an event carries besides its name, such as a temperature or a time of day: texts, numbers and truths by name.
 *
 * <p>Threading: immutable.
 *
 * @param byName in the order of the names; each a {@link String}, {@link Double} or {@link Boolean}
 * @since 0.1
 */
public record Values(Map<String, Object> byName) {
    /** No values at all. */
    public static final Values NONE = new Values(Map.of());

    /** How many an event can carry. */
    public static final int MOST = 64;

    /** How many characters the names and the texts may have in all. */
    public static final int MOST_CHARACTERS = 16_384;

    /**
     * Since events wait, are remembered and are kept in journals, what they carry is bounded.
     *
     * @throws IllegalArgumentException if a value is neither a text, a number nor a truth, or they are more than {@value #MOST}
     *     or longer than {@value #MOST_CHARACTERS} characters in all
     */
    public Values {
        requireFew(byName);
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
            characters += each.getKey().length() + (each.getValue() instanceof String text ? text.length() : 0);
        }
        if (characters > MOST_CHARACTERS) {
            throw new IllegalArgumentException("the values of an event have " + characters + " characters, at most "
                    + MOST_CHARACTERS + " are allowed; send a reference instead");
        }
    }

    private static Object plain(String name, Object value) {
        if (value instanceof Number number) {
            return number.doubleValue();
        }
        if (value instanceof String || value instanceof Boolean) {
            return value;
        }
        throw new IllegalArgumentException("the value " + name + " is a "
                + value.getClass().getSimpleName() + "; allowed are texts, numbers and true or false");
    }

    /** One value. @throws IllegalArgumentException if it is neither a text, a number nor a truth */
    public static Values of(String name, Object value) {
        return new Values(Map.of(name, value));
    }

    /** These and one more, or another in its place. */
    public Values with(String name, Object value) {
        TreeMap<String, Object> more = new TreeMap<>(byName);
        more.put(name, value);
        return new Values(more);
    }

    /** Whether there are none. */
    public boolean isEmpty() {
        return byName.isEmpty();
    }

    /** A number. @throws IllegalArgumentException if there is no number of that name */
    public double number(String name) {
        return require(name, Double.class);
    }

    /** A text. @throws IllegalArgumentException if there is no text of that name */
    public String text(String name) {
        return require(name, String.class);
    }

    /** Whether something is so. @throws IllegalArgumentException if nothing of that name is true or false */
    public boolean truth(String name) {
        return require(name, Boolean.class);
    }

    private <T> T require(String name, Class<T> type) {
        Object value = byName.get(name);
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
                text.append(text.isEmpty() ? "" : ", ").append(name).append('=').append(value));
        return text.toString();
    }
}
