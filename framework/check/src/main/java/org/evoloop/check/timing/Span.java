package org.evoloop.check.timing;

import java.math.BigDecimal;
import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.evoloop.statemachine.ModelException;

/**
 * A closed interval of time.
 *
 * <p>Threading: immutable.
 *
 * @param minNanos the lower bound, 0 or more
 * @param maxNanos the upper bound, {@link #FOR_EVER} if there is none
 * @since 0.1
 */
public record Span(long minNanos, long maxNanos) {
    /** No limit. */
    public static final long FOR_EVER = Long.MAX_VALUE;

    private static final BigDecimal LONGEST = BigDecimal.valueOf(10_000L * 3_600_000_000_000L);
    private static final Map<String, Long> UNITS =
            Map.of("ms", 1_000_000L, "s", 1_000_000_000L, "min", 60_000_000_000L, "h", 3_600_000_000_000L);
    private static final Pattern LENGTH = Pattern.compile("(\\d+(?:\\.\\d+)?)\\s*(\\w*)");
    private static final Pattern STRICT = Pattern.compile("(<|>|less\\b|more\\b|below\\b|above\\b).*");

    /**
     * Parses {@code 200 ms .. 1 s}, or {@code 1 s}, which is from 1 s to 1 s.
     *
     * @throws ModelException saying what is wrong and how it is written
     */
    public static Span parse(String text) {
        String[] ends = text.strip().split("\\.\\.", -1);
        if (ends.length > 2) {
            throw new ModelException("'" + text.strip() + "' is not an interval; write one such as 200 ms .. 1 s");
        }
        long min = nanos(ends[0]);
        long max = ends.length == 1 ? min : nanos(ends[1]);
        if (max < min) {
            throw new ModelException("the interval " + text.strip()
                    + " is empty, since it ends before it begins; write " + length(max) + " .. " + length(min));
        }
        return new Span(min, max);
    }

    /**
     * Parses {@code 1.5 s}.
     *
     * @throws ModelException saying what is wrong and how it is written
     */
    public static long nanos(String text) {
        String stripped = text.strip();
        if (STRICT.matcher(stripped).matches()) {
            throw new ModelException("'" + stripped
                    + "' excludes its end, which cannot be decided: intervals are closed; write only the length, such "
                    + "as 3 s");
        }
        Matcher length = LENGTH.matcher(stripped);
        Long unit = length.matches() ? UNITS.get(length.group(2)) : null;
        if (unit == null) {
            throw new ModelException(
                    "'" + stripped + "' is not a length of time; write a number and ms, s, min or h, such as 200 ms");
        }
        BigDecimal nanos = new BigDecimal(length.group(1)).multiply(BigDecimal.valueOf(unit));
        if (nanos.compareTo(LONGEST) > 0 || nanos.stripTrailingZeros().scale() > 0) {
            throw new ModelException("'" + stripped + "' is too "
                    + (nanos.compareTo(LONGEST) > 0
                            ? "long; the maximum is 10000 h"
                            : "fine; the minimum is a " + "nanosecond"));
        }
        return nanos.longValueExact();
    }

    /** Formats a duration: {@code 1.5 s}. */
    public static String length(long nanos) {
        if (nanos == FOR_EVER) {
            return "for ever";
        }
        String unit = nanos == 0 || nanos >= 1_000_000_000L ? "s" : "ms";
        for (String larger : new String[] {"min", "h"}) {
            Long size = UNITS.get(larger);
            if (size != null && nanos >= size && nanos % size == 0) {
                unit = larger;
            }
        }
        BigDecimal number = BigDecimal.valueOf(nanos).divide(BigDecimal.valueOf(UNITS.getOrDefault(unit, 1L)));
        return number.stripTrailingZeros().toPlainString() + " " + unit;
    }

    /** For messages: {@code 200 ms .. 1 s}. */
    @Override
    public String toString() {
        return minNanos == maxNanos ? length(minNanos) : length(minNanos) + " .. " + length(maxNanos);
    }
}
