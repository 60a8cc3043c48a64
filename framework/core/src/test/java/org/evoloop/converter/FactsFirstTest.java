package org.evoloop.converter;

import static org.assertj.core.api.Assertions.assertThat;
import static org.evoloop.converter.Robot.at;

import org.evoloop.evolution.Outcome;
import org.evoloop.function.NewFunction;
import org.evoloop.statemachine.State;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;

/** The recorded state matches the device, whatever the device does while events wait or are being sent. */
class FactsFirstTest {
    private final Player player = new Player(NewFunction.none());

    @AfterEach
    void close() {
        player.close();
    }

    private void requireAgreement() {
        assertThat(player.states().original()).isEqualTo(player.state);
        assertThat(player.doubt()).isEmpty();
    }

    @Test
    void theDeviceActsTwiceWhileAPressWaits() {
        player.press("play");
        player.acts("play");
        player.acts("pause");
        player.settle();
        requireAgreement();
        assertThat(player.states().evolved()).isEqualTo(player.state);
    }

    @Test
    void theRecordFollowsAFactAtOnceAndTheNewModelWhenItsTurnComes() {
        player.acts("play");
        assertThat(player.states()).isEqualTo(at("Playing", "Stopped"));
        player.settle();
        assertThat(player.states()).isEqualTo(at("Playing", "Playing"));
        assertThat(player.sent).isEmpty();
    }

    @Test
    void factsOnWhichBothModelsAgreeAreOnlyFollowed() {
        player.acts("play");
        player.acts("pause");
        player.acts("play");
        player.settle();
        assertThat(player.states()).isEqualTo(at("Playing", "Playing"));
        assertThat(player.sent).isEmpty();
    }

    @Test
    void aFactThatWaitsWhenTheConverterStopsIsNotForgotten() {
        player.acts("play");
        player.press("pause");
        player.converter.stop();
        player.acts("stop");
        assertThat(player.states()).isEqualTo(at("Stopped", "Stopped"));
        assertThat(player.converter.status().queue().refused()).isEqualTo(1);

        player.converter.start();
        player.settle();
        assertThat(player.states()).isEqualTo(at("Stopped", "Stopped"));
        assertThat(player.outcomes()).containsExactly("play HANDLED", "stop HANDLED");
        requireAgreement();
    }

    @Test
    void aPlanThatTheDeviceOvertakesBeforeItIsSentIsMadeAnew() {
        player.acts("play");
        player.settle();
        player.press("pause");
        // The device is stopped by hand before it becomes ready for the press.
        player.device.awaitReady = () -> {
            player.device.awaitReady = () -> {};
            player.acts("stop");
        };
        player.settle();
        requireAgreement();
        assertThat(player.sent)
                .as("the new model hears first that the player was stopped, and pause means nothing there")
                .isEmpty();
        assertThat(player.states()).isEqualTo(at("Stopped", "Stopped"));
    }

    @Test
    void aDeviceThatReportsInOrderIsNeverInDoubt() {
        player.device.reportsInOrder = true;
        player.before = () -> {
            player.before = () -> {};
            player.acts("play");
        };
        player.press("play");
        player.settle();
        requireAgreement();

        player.after = () -> {
            player.after = () -> {};
            player.acts("stop");
        };
        player.press("pause");
        player.settle();
        requireAgreement();
    }

    @Test
    void aFindingMovesTheRecordAtOnce() {
        player.state = new State("Paused");
        player.found();
        assertThat(player.states().original()).isEqualTo(player.state);
        player.settle();
        assertThat(player.states()).isEqualTo(at("Paused", "Paused"));
        assertThat(player.last().outcome()).isEqualTo(Outcome.HANDLED);
        assertThat(player.sent).isEmpty();
    }
}
