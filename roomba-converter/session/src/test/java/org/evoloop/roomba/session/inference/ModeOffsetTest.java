package org.evoloop.roomba.session.inference;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.OptionalInt;
import org.junit.jupiter.api.Test;

class ModeOffsetTest {
    private final ModeOffset offset = new ModeOffset(OptionalInt.empty());

    /** The robot sends this many frames; returns how often it had to be sent a Start. */
    private int frames(int count, int reported) {
        int starts = 0;
        for (int frame = 0; frame < count; frame++) {
            starts += offset.update(reported) ? 1 : 0;
        }
        return starts;
    }

    @Test
    void aRobotThatShowsPassiveKeepsToTheSpecification() {
        assertThat(frames(1, 1)).isZero();
        assertThat(offset.isKnown()).isTrue();
        assertThat(offset.value()).isZero();
        assertThat(frames(1_000, 2)).as("later it is in Safe mode").isZero();
        assertThat(offset.value()).isZero();
    }

    @Test
    void aRobotThatShowsSafeHoweverOftenItIsSentToPassiveReportsOneTooHigh() {
        assertThat(frames(ModeOffset.SURE_FRAMES - 1, 2)).isGreaterThanOrEqualTo(4);
        assertThat(offset.isKnown()).isFalse();
        frames(1, 2);
        assertThat(offset.value()).isEqualTo(1);
        assertThat(frames(100, 2)).isZero();
    }

    @Test
    void aRobotThatWasInSafeModeAndObeysAtLastKeepsToTheSpecification() {
        frames(ModeOffset.SURE_FRAMES - 1, 2);
        frames(1, 1);
        assertThat(offset.isKnown()).isTrue();
        assertThat(offset.value()).isZero();
    }

    @Test
    void textThatLooksLikeAFrameIsIgnored() {
        assertThat(frames(1_000, 32)).isZero();
        assertThat(offset.isKnown()).isFalse();
    }

    @Test
    void aModeThatTheOffsetRulesOutProvesItWrong() {
        ModeOffset given = new ModeOffset(OptionalInt.of(0));
        given.update(4);
        assertThat(given.value()).as("one frame may be corrupted").isZero();
        given.update(4);
        assertThat(given.value()).isEqualTo(1);
        given.update(0);
        given.update(0);
        assertThat(given.value()).isZero();
    }
}
