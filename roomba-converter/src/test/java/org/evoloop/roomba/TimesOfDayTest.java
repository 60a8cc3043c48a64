package org.evoloop.roomba;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.time.DayOfWeek;
import java.time.LocalTime;
import java.util.List;
import org.evoloop.time.TimeOfWeek;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** The options --clean-at and --quiet-hours. */
class TimesOfDayTest {
    @ParameterizedTest
    @ValueSource(strings = {"", "22:00", "22-7", "22:00-25:00", "22:00-07:00-08:00", "late-early"})
    void otherQuietHoursAreRefused(String text) {
        assertThatThrownBy(() -> ConverterOptions.quietHours(text))
                .hasMessage("--quiet-hours is " + text + "; give two times of day, for example 22:00-07:00");
    }

    @Test
    void aTimetableNamesItsDays() {
        assertThat(ConverterOptions.cleanAt("09:00")).isEqualTo(new TimeOfWeek(LocalTime.of(9, 0), List.of()));
        assertThat(ConverterOptions.cleanAt("Mon,FRIDAY 18:30"))
                .isEqualTo(new TimeOfWeek(LocalTime.of(18, 30), List.of(DayOfWeek.MONDAY, DayOfWeek.FRIDAY)));
    }

    @ParameterizedTest
    @ValueSource(strings = {"", "9", "24:00", "09:60", "MO 09:00", "MON,,FRI 09:00", "MON TUE 09:00", "09:00 MON"})
    void otherTimesAreRefused(String text) {
        assertThatThrownBy(() -> ConverterOptions.cleanAt(text))
                .hasMessage("--clean-at is " + text
                        + "; give a time of day, alone or after the days, for example 09:00 or MON,FRI 09:00");
    }
}
