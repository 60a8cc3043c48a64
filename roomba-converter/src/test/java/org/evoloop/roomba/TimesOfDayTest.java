package org.evoloop.roomba;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.time.DayOfWeek;
import java.time.Duration;
import java.time.LocalTime;
import java.time.ZonedDateTime;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** The options --clean-at and --quiet-hours. */
class TimesOfDayTest {
    private static Duration left(String hours, String now) {
        return QuietHours.parse(hours).left(ZonedDateTime.parse("2026-11-23T" + now + ":00+01:00[Europe/Berlin]"));
    }

    @ParameterizedTest
    @CsvSource({
        "22:00-07:00, 21:59, PT0S",
        "22:00-07:00, 22:00, PT9H",
        "22:00-07:00, 23:30, PT7H30M",
        "22:00-07:00, 06:59, PT1M",
        "22:00-07:00, 07:00, PT0S",
        "12:30-14:00, 13:00, PT1H",
        "12:30-14:00, 14:00, PT0S",
        "08:00-08:00, 08:00, PT0S",
    })
    void theyEndAtTheirTime(String hours, String now, Duration left) {
        assertThat(left(hours, now)).isEqualTo(left);
    }

    @Test
    void aNightThatLosesAnHourIsShorter() {
        ZonedDateTime evening = ZonedDateTime.parse("2026-03-28T23:00:00+01:00[Europe/Berlin]");
        assertThat(QuietHours.parse("22:00-07:00").left(evening)).isEqualTo(Duration.ofHours(7));
    }

    @ParameterizedTest
    @ValueSource(strings = {"", "22:00", "22-7", "22:00-25:00", "22:00-07:00-08:00", "late-early"})
    void otherQuietHoursAreRefused(String text) {
        assertThatThrownBy(() -> QuietHours.parse(text))
                .hasMessage("--quiet-hours is " + text + "; give two times of day, for example 22:00-07:00");
    }

    @Test
    void aTimetableNamesItsDays() {
        assertThat(Timetable.parse("09:00")).isEqualTo(new Timetable(LocalTime.of(9, 0), List.of()));
        assertThat(Timetable.parse("Mon,FRIDAY 18:30"))
                .isEqualTo(new Timetable(LocalTime.of(18, 30), List.of(DayOfWeek.MONDAY, DayOfWeek.FRIDAY)));
    }

    @ParameterizedTest
    @ValueSource(strings = {"", "9", "24:00", "09:60", "MO 09:00", "MON,,FRI 09:00", "MON TUE 09:00", "09:00 MON"})
    void otherTimesAreRefused(String text) {
        assertThatThrownBy(() -> Timetable.parse(text))
                .hasMessage("--clean-at is " + text
                        + "; give a time of day, alone or after the days, for example 09:00 or MON,FRI 09:00");
    }
}
