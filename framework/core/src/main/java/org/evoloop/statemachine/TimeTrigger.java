package org.evoloop.statemachine;

import java.math.BigDecimal;
import java.time.Duration;
import java.time.temporal.ChronoUnit;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.jspecify.annotations.Nullable;

/**
 * The text of a UML time trigger: {@code tm(2s)}, {@code after(500 ms)}, {@code after 2 s}, {@code after 1.5 minutes},
 * and with or without those words a duration of ISO 8601 such as {@code PT1M30S}.
 *
 * <p>Where nested states have equal time triggers, their names include the state: {@code tm(2s) in On}.
 *
 * <p>A unit is required: UML does not define one, and a wrong guess may be a thousand times too long.
 */
final class TimeTrigger {
    private static final String OWNER = "(?:\\s+in\\s+.*)?";
    private static final String NUMBER = "([0-9]+(?:[.,][0-9]+)?)";
    private static final List<Pattern> FORMS = List.of(
            Pattern.compile("(?:tm|after)\\s*\\((.*?)\\)" + OWNER, Pattern.CASE_INSENSITIVE),
            Pattern.compile("after\\s+([0-9.].*?|PT?[0-9].*?)" + OWNER, Pattern.CASE_INSENSITIVE),
            Pattern.compile("(P[0-9T.,YMWDHS]*[0-9][YMWDHS])" + OWNER));

    private static final Pattern DURATION = Pattern.compile("([0-9]+(?:\\.[0-9]+)?)\\s*([a-z]+)");

    private static final Pattern DECIMAL_COMMA = Pattern.compile("^[0-9.]*,");

    private static final Map<String, ChronoUnit> UNITS = Map.ofEntries(
            Map.entry("ms", ChronoUnit.MILLIS),
            Map.entry("msec", ChronoUnit.MILLIS),
            Map.entry("millisecond", ChronoUnit.MILLIS),
            Map.entry("milliseconds", ChronoUnit.MILLIS),
            Map.entry("s", ChronoUnit.SECONDS),
            Map.entry("sec", ChronoUnit.SECONDS),
            Map.entry("second", ChronoUnit.SECONDS),
            Map.entry("seconds", ChronoUnit.SECONDS),
            Map.entry("min", ChronoUnit.MINUTES),
            Map.entry("minute", ChronoUnit.MINUTES),
            Map.entry("minutes", ChronoUnit.MINUTES),
            Map.entry("h", ChronoUnit.HOURS),
            Map.entry("hour", ChronoUnit.HOURS),
            Map.entry("hours", ChronoUnit.HOURS),
            Map.entry("d", ChronoUnit.DAYS),
            Map.entry("day", ChronoUnit.DAYS),
            Map.entry("days", ChronoUnit.DAYS));

    private static final Pattern ISO = Pattern.compile("P(?=[0-9]|T[0-9])" + part('Y') + part('M') + part('W')
            + part('D') + "(?:T(?=[0-9])" + part('H') + part('M') + part('S') + ")?");

    /** The unit of each group of {@link #ISO}. */
    private static final List<ChronoUnit> ISO_UNITS = List.of(
            ChronoUnit.YEARS,
            ChronoUnit.MONTHS,
            ChronoUnit.WEEKS,
            ChronoUnit.DAYS,
            ChronoUnit.HOURS,
            ChronoUnit.MINUTES,
            ChronoUnit.SECONDS);

    private static final Pattern WITHOUT_UNIT = Pattern.compile("[0-9]*\\.?[0-9]+");

    private TimeTrigger() {}

    private static String part(char unit) {
        return "(?:" + NUMBER + unit + ")?";
    }

    /** Matches the form of a time trigger, with the supposed duration as its first group; null for any other event. */
    private static @Nullable Matcher form(String eventName) {
        String text = eventName.strip();
        for (Pattern pattern : FORMS) {
            Matcher form = pattern.matcher(text);
            if (form.matches()) {
                return form;
            }
        }
        return null;
    }

    static Optional<Duration> parse(String eventName) {
        Matcher form = form(eventName);
        if (form == null) {
            return Optional.empty();
        }
        String text = form.group(1).strip();
        Matcher iso = ISO.matcher(text.toUpperCase(Locale.ROOT));
        if (iso.matches()) {
            return Optional.of(iso(eventName, iso));
        }
        Matcher duration = DURATION.matcher(text.toLowerCase(Locale.ROOT));
        ChronoUnit unit = duration.matches() ? UNITS.get(duration.group(2)) : null;
        if (unit != null) {
            return Optional.of(exact(eventName, nanos(duration.group(1), unit)));
        }
        if (DECIMAL_COMMA.matcher(text).find()) {
            throw new ModelException("time trigger '" + eventName + "' has a comma; write a point before decimals and"
                    + " nothing between thousands, for example after 2.5 s");
        }
        throw new ModelException(
                WITHOUT_UNIT.matcher(text).matches()
                        ? "time trigger '" + eventName
                                + "' has no unit; write one (ms, s, min, h or d), for example after " + text
                                + " s, or give --time-unit ms or --time-unit s for all that have none"
                        : "time trigger '" + eventName
                                + "' needs a number and a unit (ms, s, min, h or d), for example tm(2s) or after 2 s, or"
                                + " a duration of ISO 8601, for example PT2S");
    }

    private static Duration iso(String eventName, Matcher iso) {
        BigDecimal nanos = BigDecimal.ZERO;
        for (int unit = 0; unit < ISO_UNITS.size(); unit++) {
            String number = iso.group(1 + unit);
            if (number != null && unit < ISO_UNITS.indexOf(ChronoUnit.WEEKS)) {
                throw new ModelException("time trigger '" + eventName
                        + "' counts years or months, which are not all of one length; count days");
            }
            if (number != null) {
                nanos = nanos.add(nanos(number.replace(',', '.'), ISO_UNITS.get(unit)));
            }
        }
        return exact(eventName, nanos);
    }

    private static BigDecimal nanos(String amount, ChronoUnit unit) {
        return new BigDecimal(amount)
                .multiply(BigDecimal.valueOf(unit.getDuration().toNanos()));
    }

    private static Duration exact(String eventName, BigDecimal nanos) {
        // Clocks count nanoseconds in a long: 292 years.
        if (nanos.compareTo(BigDecimal.valueOf(Long.MAX_VALUE)) > 0) {
            throw new ModelException("time trigger '" + eventName + "' is longer than 292 years; write a shorter one");
        }
        return Duration.ofNanos(nanos.longValue());
    }

    /** The text with this unit added if it is a time trigger without one. */
    static String withUnit(String eventName, String abbreviation) {
        Matcher form = form(eventName);
        if (form == null || !WITHOUT_UNIT.matcher(form.group(1).strip()).matches()) {
            return eventName;
        }
        String text = eventName.strip();
        String number = form.group(1).strip();
        int end = text.indexOf(number, form.start(1)) + number.length();
        return text.substring(0, end) + " " + abbreviation + text.substring(end);
    }
}
