package org.evoloop.function;

import static java.util.Objects.requireNonNull;

import java.math.BigDecimal;
import java.math.RoundingMode;
import java.util.Locale;

/**
 * One value describing a device or a function's progress, for people and programs: {@code battery 93 %}.
 *
 * <p>Threading: immutable.
 *
 * @param name its name in lower camel case, such as {@code timeLeft}; the key in JSON
 * @param value a {@link Boolean}, a {@link Long}, a finite {@link Double} or a {@link String}
 * @param unit the unit of a number, such as {@code %} or {@code s}; else empty
 * @since 0.1
 */
public record Reading(String name, Object value, String unit) {

    /** Longer times are also shown in minutes. */
    private static final int SHOWN_IN_SECONDS = 120;

    /** @throws IllegalArgumentException if the name is empty, or the value of another type or not finite */
    public Reading {
        requireNonNull(unit, "the unit is null");
        if (name.isEmpty()) {
            throw new IllegalArgumentException("a reading needs a name");
        }
        boolean fits = value instanceof Boolean
                || value instanceof Long
                || value instanceof String
                || (value instanceof Double number && Double.isFinite(number));
        if (!fits) {
            throw new IllegalArgumentException(
                    "reading '" + name + "' is " + value + "; give it a Boolean, a Long, a finite Double or a String");
        }
    }

    /** A boolean. */
    public static Reading of(String name, boolean value) {
        return new Reading(name, value, "");
    }

    /** A short text. */
    public static Reading of(String name, String value) {
        return new Reading(name, value, "");
    }

    /** A whole number. */
    public static Reading of(String name, long value, String unit) {
        return new Reading(name, value, unit);
    }

    /** A number. */
    public static Reading of(String name, double value, String unit) {
        return new Reading(name, value, unit);
    }

    /** Its name for people: {@code time left} for {@code timeLeft}. */
    public String words() {
        return name.replaceAll("(?<=[a-z])(?=[A-Z])", " ").toLowerCase(Locale.ROOT);
    }

    /**
     * For people, such as {@code distance 1.25 m}, {@code time left 4 min 30 s}, {@code docked}, {@code not docked} or
     * {@code error stuck}.
     */
    @Override
    public String toString() {
        String words = words();
        if (value instanceof Boolean holds) {
            return holds ? words : "not " + words;
        }
        if (value instanceof Number seconds && unit.equals("s") && seconds.doubleValue() >= SHOWN_IN_SECONDS) {
            long whole = Math.round(seconds.doubleValue());
            return words + " " + whole / 60 + " min " + whole % 60 + " s";
        }
        String number = value instanceof Double exact
                ? BigDecimal.valueOf(exact)
                        .setScale(2, RoundingMode.HALF_UP)
                        .stripTrailingZeros()
                        .toPlainString()
                : value.toString();
        return words + " " + number + (unit.isEmpty() ? "" : " " + unit);
    }
}
