package org.evoloop.time;

import java.time.DayOfWeek;
import java.time.LocalTime;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;

/**
 * A time at which something happens, as people write it: {@code 09:00} for every day, {@code MON,FRI 09:00} for some days.
 *
 * <p>Threading: immutable.
 *
 * @param time of the day
 * @param days empty for every day
 * @since 0.1
 */
public record TimeOfWeek(LocalTime time, List<DayOfWeek> days) {
    private static final Pattern TEXT =
            Pattern.compile("(?:(?<days>[A-Za-z,]+)\\s+)?(?<time>([01]\\d|2[0-3]):[0-5]\\d)");

    public TimeOfWeek {
        days = List.copyOf(days);
    }

    /**
     * Reads a time.
     *
     * @param name of what takes it, for messages
     * @throws IllegalArgumentException if the text has another form
     */
    public static TimeOfWeek parse(String name, String text) {
        Matcher parts = TEXT.matcher(text.strip());
        if (parts.matches()) {
            String names = parts.group("days");
            List<Optional<DayOfWeek>> days = names == null
                    ? List.of()
                    : Arrays.stream(names.split(",", -1)).map(TimeOfWeek::day).toList();
            if (days.stream().allMatch(Optional::isPresent)) {
                return new TimeOfWeek(
                        LocalTime.parse(parts.group("time")),
                        days.stream().flatMap(Optional::stream).toList());
            }
        }
        throw new IllegalArgumentException(name + " is " + text
                + "; give a time of day, alone or after the days, for example 09:00 or MON,FRI 09:00");
    }

    private static Optional<DayOfWeek> day(String name) {
        return Arrays.stream(DayOfWeek.values())
                .filter(day -> name.length() >= 3 && day.name().startsWith(name.toUpperCase(Locale.ROOT)))
                .findFirst();
    }

    /** As people write it. */
    @Override
    public String toString() {
        String names = days.stream().map(day -> day.name().substring(0, 3)).collect(Collectors.joining(","));
        return names.isEmpty() ? time.toString() : names + " " + time;
    }
}
