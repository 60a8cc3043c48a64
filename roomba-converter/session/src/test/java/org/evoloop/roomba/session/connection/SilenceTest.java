package org.evoloop.roomba.session.connection;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.time.Instant;
import org.evoloop.time.ManualClock;
import org.junit.jupiter.api.Test;

class SilenceTest {
    private static final Duration PERIOD = Duration.ofMillis(250);
    private static final Duration LIMIT = Duration.ofMillis(1_700);

    private final ManualClock clock = new ManualClock();
    private final Silence silence = new Silence(clock);

    /** The next check comes this much later than it is due. */
    private void check(Duration late) {
        silence.expectCheck(PERIOD);
        clock.advance(PERIOD.plus(late));
        silence.checked();
    }

    private int checksUntilNoticed() {
        int checks = 0;
        while (!silence.hasLasted(LIMIT)) {
            check(Duration.ZERO);
            checks++;
        }
        return checks;
    }

    @Test
    void isNoticedByTheFirstPunctualCheckAfterTheLimit() {
        silence.broken();
        assertThat(checksUntilNoticed()).isEqualTo(7);
        silence.broken();
        assertThat(checksUntilNoticed()).isEqualTo(7);
    }

    @Test
    void timeInWhichTheProgramWasHeldUpDoesNotCount() {
        silence.broken();
        check(Duration.ofSeconds(5));
        assertThat(checksUntilNoticed()).isEqualTo(6);
        assertThat(silence.since()).isEqualTo(Instant.EPOCH);
    }

    @Test
    void isNoticedEvenIfEachCheckIsLate() {
        silence.broken();
        for (int checks = 0; checks < 6; checks++) {
            check(Duration.ofMillis(300));
            assertThat(silence.hasLasted(LIMIT)).isFalse();
        }
        check(Duration.ofMillis(300));
        assertThat(silence.hasLasted(LIMIT)).isTrue();
    }

    @Test
    void aFrameAfterADelayEndsWhatHasNotCounted() {
        silence.broken();
        silence.expectCheck(PERIOD);
        clock.advance(Duration.ofSeconds(5));
        silence.broken();
        Instant heard = clock.wallTime();
        silence.checked();
        assertThat(checksUntilNoticed()).isEqualTo(7);
        assertThat(silence.since()).isEqualTo(heard);
    }
}
