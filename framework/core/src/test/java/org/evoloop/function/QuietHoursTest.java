package org.evoloop.function;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.time.LocalTime;
import java.time.ZonedDateTime;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Hours of the day in which a system is quiet. */
class QuietHoursTest {
    private static QuietHours hours(String from, String until) {
        return QuietHours.between(LocalTime.parse(from), LocalTime.parse(until));
    }

    @ParameterizedTest
    @CsvSource({
        "22:00, 07:00, 21:59, PT0S",
        "22:00, 07:00, 22:00, PT9H",
        "22:00, 07:00, 23:30, PT7H30M",
        "22:00, 07:00, 06:59, PT1M",
        "22:00, 07:00, 07:00, PT0S",
        "12:30, 14:00, 13:00, PT1H",
        "12:30, 14:00, 14:00, PT0S",
        "08:00, 08:00, 08:00, PT0S",
    })
    void theyEndAtTheirTime(String from, String until, String now, Duration left) {
        assertThat(hours(from, until).left(ZonedDateTime.parse("2026-11-23T" + now + ":00+01:00[Europe/Berlin]")))
                .isEqualTo(left);
    }

    @Test
    void aNightThatLosesAnHourIsShorterAndOneThatGainsOneIsLonger() {
        QuietHours night = hours("22:00", "07:00");
        assertThat(night.left(ZonedDateTime.parse("2026-03-28T23:00:00+01:00[Europe/Berlin]")))
                .isEqualTo(Duration.ofHours(7));
        assertThat(night.left(ZonedDateTime.parse("2026-10-24T23:00:00+02:00[Europe/Berlin]")))
                .isEqualTo(Duration.ofHours(9));
    }
}
