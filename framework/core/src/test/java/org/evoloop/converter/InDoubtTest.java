package org.evoloop.converter;

import static org.assertj.core.api.Assertions.assertThat;
import static org.evoloop.converter.Robot.at;

import org.evoloop.function.NewFunction;
import org.evoloop.statemachine.State;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;

/** If it is unknowable what came first, the record says so, and the device is asked for its state. */
class InDoubtTest {
    private final Player player = new Player(NewFunction.none());

    @AfterEach
    void close() {
        player.close();
    }

    /** The device pauses while stop is being sent; the resulting state depends on which came first. */
    private void pauseWhileStopIsSent() {
        player.acts("play");
        player.settle();
        player.after = () -> {
            player.after = () -> {};
            player.acts("play");
        };
        player.press("stop");
        player.settle();
    }

    @Test
    void theDeviceIsAskedWhatCameFirst() {
        player.device.canBeAsked = true;
        pauseWhileStopIsSent();
        assertThat(player.outcomes()).anyMatch(outcome -> outcome.startsWith("in doubt HANDLED"));
        assertThat(player.doubt()).isEmpty();
        assertThat(player.states().original()).isEqualTo(player.state);
    }

    @Test
    void aDeviceThatCannotReportIsAssumedToBeWhereTheReportsLeadAndIsInDoubt() {
        pauseWhileStopIsSent();
        assertThat(player.doubt()).isEqualTo("it is unknown whether the device acted before or after it took stop");
        assertThat(player.outcomes()).contains("in doubt IGNORED");

        player.found();
        player.settle();
        assertThat(player.doubt()).isEmpty();
        assertThat(player.states().original()).isEqualTo(player.state);
    }

    private void playWithoutAnAnswer() {
        player.after = () -> {
            player.after = () -> {};
            throw new UnknownEffectException("play was not answered within 2 s");
        };
        player.press("play");
        player.settle();
    }

    @Test
    void aDeviceThatHasNotAnsweredIsAskedWhereItIs() {
        player.device.canBeAsked = true;
        playWithoutAnAnswer();
        assertThat(player.outcomes()).containsExactly("play FAILED", "in doubt HANDLED");
        assertThat(player.doubt()).isEmpty();
        assertThat(player.states()).isEqualTo(at("Playing", "Playing"));
        assertThat(player.sent).containsExactly("play");
    }

    @Test
    void whatHasNotBeenAnsweredIsTakenToHaveHadNoEffectUntilTheDeviceIsFound() {
        playWithoutAnAnswer();
        assertThat(player.doubt())
                .isEqualTo(
                        "it is unknown whether play had its effect: Device.execute: play was not answered within 2 s");
        assertThat(player.states()).isEqualTo(at("Stopped", "Stopped"));
        player.found();
        player.settle();
        assertThat(player.doubt()).isEmpty();
        assertThat(player.states()).isEqualTo(at("Playing", "Playing"));
    }

    @Test
    void whereTheOrderMakesNoDifferenceThereIsNoDoubt() {
        player.acts("play");
        player.settle();
        player.after = () -> {
            player.after = () -> {};
            // Whichever stop came first, the device is in Stopped.
            player.acts("stop");
        };
        player.press("stop");
        player.settle();
        assertThat(player.doubt()).isEmpty();
        assertThat(player.states()).isEqualTo(at("Stopped", "Stopped"));
    }

    @Test
    void aDeviceThatNamesAStateItsModelDoesNotHaveIsReportedAsFaulty() {
        player.device.canBeAsked = true;
        player.after = () -> {
            player.after = () -> {};
            player.state = new State("Playin");
            throw new UnknownEffectException("play was not answered within 2 s");
        };
        player.press("play");
        player.settle();
        assertThat(player.last().detail())
                .contains("the device says that it is in Playin, which is not a state of its model")
                .contains("Playing");
        assertThat(player.outcomes()).containsExactly("play FAILED", "in doubt FAILED");
        assertThat(player.doubt()).isNotEmpty();
    }
}
