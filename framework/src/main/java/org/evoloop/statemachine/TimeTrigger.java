package org.evoloop.statemachine;

import java.math.BigDecimal;
import java.time.Duration;
import java.time.temporal.ChronoUnit;
import java.util.List;
import java.util.Locale;
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
    private static final Pattern DURATION = Pattern.compile(
            "([0-9]+(?:\\.[0-9]+)?)\\s*(?:(ms|msec|milliseconds?)|(s|sec|seconds?)|(min|minutes?)|(h|hours?))");

    /** The unit of each group of {@link #DURATION} but the first. */
    private static final List<ChronoUnit> UNITS =
            List.of(ChronoUnit.MILLIS, ChronoUnit.SECONDS, ChronoUnit.MINUTES, ChronoUnit.HOURS);

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
        if (duration.matches()) {
            for (int unit = 0; unit < UNITS.size(); unit++) {
                if (duration.group(2 + unit) != null) {
                    return Optional.of(exact(eventName, new BigDecimal(duration.group(1)), UNITS.get(unit)));
                }
            }
        }
        throw new ModelException("time trigger '" + eventName
                + "' needs a number and a unit (ms, s, min or h), for example tm(2s) or after 2 s");
    }

    private static Duration exact(String eventName, BigDecimal amount, ChronoUnit unit) {
        BigDecimal nanos = amount.multiply(BigDecimal.valueOf(unit.getDuration().toNanos()));
        // Clocks count nanoseconds in a long: 292 years.
        if (nanos.compareTo(BigDecimal.valueOf(Long.MAX_VALUE)) > 0) {
            throw new ModelException("time trigger '" + eventName + "' is longer than 292 years; write a shorter one");
        }
        return Duration.ofNanos(nanos.longValue());
    }
}
