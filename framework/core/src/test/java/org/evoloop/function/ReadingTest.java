package org.evoloop.function;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import org.junit.jupiter.api.Test;

class ReadingTest {
    @Test
    void itReadsLikeWords() {
        assertThat(Reading.of("battery", 93, "%")).hasToString("battery 93 %");
        assertThat(Reading.of("timeLeft", 100.0, "s")).hasToString("time left 100 s");
        assertThat(Reading.of("timeLeft", 119, "s")).hasToString("time left 119 s");
        assertThat(Reading.of("timeLeft", 270, "s")).hasToString("time left 4 min 30 s");
        assertThat(Reading.of("timeLeft", 179.6, "s")).hasToString("time left 3 min 0 s");
        assertThat(Reading.of("distance", 1.256, "m")).hasToString("distance 1.26 m");
        assertThat(Reading.of("docked", true)).hasToString("docked");
        assertThat(Reading.of("docked", false)).hasToString("not docked");
        assertThat(Reading.of("error", "stuck")).hasToString("error stuck");
    }

    @Test
    void whatJsonCannotHoldIsRefused() {
        assertThatThrownBy(() -> Reading.of("distance", Double.NaN, "m"))
                .hasMessage("reading 'distance' is NaN; give it a Boolean, a Long, a finite Double or a String");
        assertThatThrownBy(() -> new Reading("distance", 1.5f, "m")).hasMessageContaining("'distance' is 1.5");
        assertThatThrownBy(() -> Reading.of("", true)).hasMessage("a reading needs a name");
    }
}
