package org.evoloop.statemachine;

import java.math.BigDecimal;
import java.time.Duration;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * The text of a UML time trigger: {@code tm(2s)}, {@code after(500 ms)}, {@code after 2 s}, {@code after 1.5 minutes}.
 *
 * <p>Where states around each other have equal time triggers, their names tell whose timer it is: {@code tm(2s) in On}.
 *
 * <p>A unit is required, since UML leaves it to the reader and a wrong guess is a thousand times too long.
 */
final class TimeTrigger {
    private static final String OWNER = "(?:\\s+in\\s+.*)?";
    private static final Pattern CALL =
            Pattern.compile("(?:tm|after)\\s*\\((.*?)\\)" + OWNER, Pattern.CASE_INSENSITIVE);
    private static final Pattern PHRASE = Pattern.compile("after\\s+([0-9.].*?)" + OWNER, Pattern.CASE_INSENSITIVE);
    private static final Pattern DURATION = Pattern.compile("([0-9]+(?:\\.[0-9]+)?)\\s*([a-z]+)");

    private static final Map<String, Long> NANOS = Map.ofEntries(
            Map.entry("ms", 1_000_000L),
            Map.entry("msec", 1_000_000L),
            Map.entry("millisecond", 1_000_000L),
            Map.entry("milliseconds", 1_000_000L),
            Map.entry("s", 1_000_000_000L),
            Map.entry("sec", 1_000_000_000L),
            Map.entry("second", 1_000_000_000L),
            Map.entry("seconds", 1_000_000_000L),
            Map.entry("min", 60_000_000_000L),
            Map.entry("minute", 60_000_000_000L),
            Map.entry("minutes", 60_000_000_000L),
            Map.entry("h", 3_600_000_000_000L),
            Map.entry("hour", 3_600_000_000_000L),
            Map.entry("hours", 3_600_000_000_000L));

    private TimeTrigger() {}

    static Optional<Duration> parse(String eventName) {
        String text = eventName.strip();
        Matcher form = CALL.matcher(text);
        if (!form.matches()) {
            form = PHRASE.matcher(text);
            if (!form.matches()) {
                return Optional.empty();
            }
        }
        Matcher duration = DURATION.matcher(form.group(1).strip().toLowerCase(Locale.ROOT));
        Long unitNanos = duration.matches() ? NANOS.get(duration.group(2)) : null;
        if (unitNanos == null) {
            throw new ModelException("time trigger '" + eventName
                    + "' needs a number and a unit (ms, s, min or h), for example tm(2s) or after 2 s");
        }
        return Optional.of(exact(eventName, new BigDecimal(duration.group(1)).multiply(BigDecimal.valueOf(unitNanos))));
    }

    private static Duration exact(String eventName, BigDecimal nanos) {
        // Clocks count nanoseconds in a long: 292 years.
        if (nanos.compareTo(BigDecimal.valueOf(Long.MAX_VALUE)) > 0) {
            throw new ModelException("time trigger '" + eventName + "' is longer than 292 years; write a shorter one");
        }
        return Duration.ofNanos(nanos.longValue());
    }
}
