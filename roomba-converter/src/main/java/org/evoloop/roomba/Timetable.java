package org.evoloop.roomba;

import java.time.DayOfWeek;
import java.time.LocalTime;
import java.time.ZoneId;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import org.evoloop.converter.TimetableMonitor;

/**
 * A time at which the robot must clean, as its owner writes it: {@code 09:00} for every day, {@code MON,FRI 09:00} for
 * some days.
 *
 * @param days empty for every day
 */
record Timetable(LocalTime time, List<DayOfWeek> days) {
    private static final Pattern TEXT =
            Pattern.compile("(?:(?<days>[A-Za-z,]+)\\s+)?(?<time>([01]\\d|2[0-3]):[0-5]\\d)");

    /** @throws IllegalArgumentException if the text, of the option, has another form */
    static Timetable parse(String text) {
        return parse("--clean-at", text);
    }

    /**
     * Reads a time.
     *
     * @param name of what is set, for messages
     * @throws IllegalArgumentException if the text has another form
     */
    static Timetable parse(String name, String text) {
        Matcher parts = TEXT.matcher(text.strip());
        if (parts.matches()) {
            String names = parts.group("days");
            List<Optional<DayOfWeek>> days = names == null
                    ? List.of()
                    : Arrays.stream(names.split(",", -1)).map(Timetable::day).toList();
            if (days.stream().allMatch(Optional::isPresent)) {
                return new Timetable(
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

    /** A controller that raises {@code schedule} at these times. */
    static TimetableMonitor monitor(List<Timetable> entries) {
        TimetableMonitor monitor = new TimetableMonitor("Timetable", ZoneId.systemDefault());
        entries.forEach(entry -> entry.addTo(monitor));
        return monitor;
    }

    void addTo(TimetableMonitor monitor) {
        monitor.at(time, RobotEvents.SCHEDULE, days.toArray(DayOfWeek[]::new));
    }

    /** As its owner writes it. */
    @Override
    public String toString() {
        String names = days.stream().map(day -> day.name().substring(0, 3)).collect(Collectors.joining(","));
        return names.isEmpty() ? time.toString() : names + " " + time;
    }
}
