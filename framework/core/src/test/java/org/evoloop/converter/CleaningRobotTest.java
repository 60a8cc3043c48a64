package org.evoloop.converter;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalStateException;
import static org.evoloop.converter.Robot.at;

import java.io.IOException;
import java.time.Duration;
import java.util.List;
import org.evoloop.converter.recording.Transcript;
import org.evoloop.evolution.Outcome;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;

/** The paper's scenario, step by step under a manual clock. */
class CleaningRobotTest {
    private final LoggedLines transcript = new LoggedLines(Transcript.LOGGER);
    private final Robot robot = new Robot();

    @AfterEach
    void close() {
        robot.close();
        transcript.close();
    }

    @Test
    void movesToTheRemoteStartingPointAsInThePapersFirstListing() throws InterruptedException {
        robot.panel("Clean", true).panel("Spot", false).arrives().device("endSpot");

        assertThat(robot.sent).containsExactly("Spot");
        assertThat(robot.states()).isEqualTo(at("On", "On"));
        assertThat(robot.moves).containsExactly("starts", "ends");
        assertThat(transcript.lines())
                .containsExactly(
                        "----   button_event : Clean   -----",
                        "Monitor",
                        " inputs Clean event.",
                        "Analyze",
                        " original_current_state: Off",
                        " new_current_state: Off",
                        " mode: Use existing functions",
                        "Plan",
                        "Execute",
                        " MAPE-K loop will send this event : Clean",
                        " original_current_state: On",
                        " new_current_state: On",
                        "----   button_event : Spot   -----",
                        "Monitor",
                        " inputs Spot event.",
                        "Analyze",
                        " original_current_state: On",
                        " new_current_state: On",
                        " mode: Use new functions",
                        "Plan",
                        " MAPE-K loop does not send events.",
                        "Execute",
                        " Operate existing functions for Move in the another thread",
                        " original_current_state: On",
                        " new_current_state: Move",
                        "***  Start to run new functions. ***",
                        "***  Arrive at target point  ***",
                        "***  Send arriveSpot event to EventConverter.  ***",
                        "***  Stop new functions  ***",
                        "----   internal_event : arriveSpot   -----",
                        "Monitor",
                        " inputs arriveSpot event.",
                        "Analyze",
                        " original_current_state: On",
                        " new_current_state: Move",
                        " mode: Use existing functions",
                        "Plan",
                        "Execute",
                        " MAPE-K loop will send this event : Spot",
                        " Spot command",
                        " original_current_state: Spot",
                        " new_current_state: Spot",
                        "----   internal_event : endSpot   -----",
                        "Monitor",
                        " inputs endSpot event.",
                        "Analyze",
                        " original_current_state: Spot",
                        " new_current_state: Spot",
                        " mode: Use existing functions",
                        "Plan",
                        "Execute",
                        " MAPE-K loop will send this event : endSpot",
                        " original_current_state: On",
                        " new_current_state: On");
    }

    @Test
    void takesTheDetourFromCleanToSpotAsInThePapersSecondListing() throws InterruptedException {
        robot.controller("Clean").controller("Clean");
        transcript.lines().clear();
        robot.controller("Clean").controller("Clean");

        assertThat(robot.sent).containsExactly("Clean", "Clean", "Clean", "Spot");
        assertThat(robot.states()).isEqualTo(at("Spot", "Spot"));
        assertThat(transcript.lines())
                .containsExactly(
                        "----   button_event : Clean   -----",
                        "Monitor",
                        " inputs Clean event.",
                        "Analyze",
                        " original_current_state: Clean",
                        " new_current_state: Clean",
                        " mode: Use new functions",
                        "Plan",
                        " MAPE-K loop does not send events.",
                        "Execute",
                        " Operate existing functions for SpotWait in the another thread",
                        " original_current_state: Clean",
                        " new_current_state: SpotWait",
                        "***  Start to run new functions. ***",
                        "----   button_event : Clean   -----",
                        "Monitor",
                        " inputs Clean event.",
                        "Analyze",
                        " original_current_state: Clean",
                        " new_current_state: SpotWait",
                        " mode: Use new functions",
                        "Plan",
                        "Execute",
                        " MAPE-K loop will send this event : Clean",
                        " Clean command",
                        " MAPE-K loop will send this event : Spot",
                        " Spot command",
                        " original_current_state: Spot",
                        " new_current_state: Spot");
    }

    @Test
    void goesBackToOnWhenTheSecondPressNeverComes() throws InterruptedException {
        robot.controller("Clean").controller("Clean").controller("Clean");

        robot.pass(Duration.ofMillis(4999));
        assertThat(robot.states()).isEqualTo(at("Clean", "SpotWait"));

        robot.pass(Duration.ofMillis(1));
        assertThat(robot.states()).isEqualTo(at("On", "On"));
        assertThat(robot.sent).containsExactly("Clean", "Clean", "Clean");
    }

    @Test
    void followsTheRobotWhenItPausesByItself() throws InterruptedException {
        robot.controller("Clean").controller("Clean").panel("Clean", true);

        assertThat(robot.states()).isEqualTo(at("On", "SpotWait"));
        assertThat(transcript.lines())
                .endsWith(
                        " Operate existing functions for SpotWait in the another thread",
                        " original_current_state: On",
                        " new_current_state: SpotWait",
                        "***  Start to run new functions. ***");

        robot.panel("Clean", false);
        assertThat(robot.sent).containsExactly("Clean", "Clean", "Spot");
        assertThat(robot.states()).isEqualTo(at("Spot", "Spot"));
    }

    @Test
    void neverReceivesATimeoutOfAStateThatWasLeft() throws InterruptedException {
        robot.controller("Clean").controller("Clean").controller("Clean");
        // The second press is already queued when the timer fires, so the timeout comes after it and is stale.
        robot.panel.press("Clean");
        robot.converter.observe(robot.panel);
        robot.clock.advance(Duration.ofSeconds(5));
        robot.settle();

        assertThat(robot.states()).isEqualTo(at("Spot", "Spot"));
        assertThat(robot.last().outcome()).isEqualTo(Outcome.STALE);
        assertThat(robot.converter.status().events().stale()).isEqualTo(1);
        assertThat(transcript.lines()).doesNotContain("----   internal_event : timeout   -----");
    }

    @Test
    void startsEveryVisitsTimerAnew() throws InterruptedException {
        robot.controller("Clean").controller("Clean").controller("Clean").pass(Duration.ofSeconds(3));
        robot.controller("Clean").device("endSpot").controller("Clean").controller("Clean");
        assertThat(robot.states()).isEqualTo(at("Clean", "SpotWait"));

        robot.pass(Duration.ofSeconds(3));
        assertThat(robot.states()).isEqualTo(at("Clean", "SpotWait"));
        robot.pass(Duration.ofSeconds(2));
        assertThat(robot.states()).isEqualTo(at("On", "On"));
        assertThat(robot.clock.pendingTasks()).isZero();
    }

    @Test
    void staysWhereTheFirstOfTwoEventsTookTheDeviceWhenTheSecondFails() throws InterruptedException {
        robot.controller("Clean").controller("Clean").controller("Clean");
        robot.brokenCable = new IOException("the cable is out");
        robot.soundSteps = 3;

        robot.controller("Clean");

        assertThat(robot.sent).containsExactly("Clean", "Clean", "Clean");
        assertThat(robot.states()).isEqualTo(at("On", "SpotWait"));
        assertThat(robot.last().outcome()).isEqualTo(Outcome.FAILED);
        assertThat(robot.last().detail()).contains("the cable is out");
        assertThat(robot.converter.status().events().failed()).isEqualTo(1);
        assertThat(transcript.lines()).doesNotContain(" Spot command");

        // The state could not be left: its timer is restarted, and the next press continues from there.
        robot.brokenCable = null;
        robot.controller("Clean");
        assertThat(robot.sent).endsWith("Clean", "Spot");
        assertThat(robot.states()).isEqualTo(at("Spot", "Spot"));
    }

    @Test
    void countsWhatTheNewModelDoesNotAccept() throws InterruptedException {
        robot.controller("Spot");

        assertThat(robot.sent).isEmpty();
        assertThat(robot.last().outcome()).isEqualTo(Outcome.IGNORED);
        assertThat(robot.converter.status().events().ignored()).isEqualTo(1);
    }

    @Test
    void notifiesTheExecuteComponentOfTheStatesBeforeAFunctionStarts() throws InterruptedException {
        robot.panel("Clean", true).panel("Spot", false);

        assertThat(robot.settled).containsExactly("(Off, Off)", "(On, On)", "(On, Move)");
    }

    @Test
    void dropsWhatFindsTheQueueFullButNeverWhatTheDeviceDid() throws InterruptedException {
        try (Robot small = new Robot(2)) {
            small.panel.press("Clean");
            small.panel.press("Clean");
            for (int lost = 0; lost < 3; lost++) {
                assertThatIllegalStateException().isThrownBy(() -> small.panel.press("Clean"));
            }
            small.panel.pressed("Clean", true);
            small.converter.observe(small.panel);

            assertThat(small.converter.status().queue().dropped()).isEqualTo(3);
            assertThat(small.converter.status().queue().depth()).isEqualTo(3);
            assertThat(small.last().outcome()).isEqualTo(Outcome.DROPPED);
        }
    }

    @Test
    void endsItsFunctionWhenStoppedAndBeginsItAnewWhenStartedAgain() throws InterruptedException {
        robot.panel("Clean", true).panel("Spot", false);
        robot.converter.stop();
        assertThat(robot.moves).containsExactly("starts", "ends");
        robot.panel("Clean", true);
        assertThat(robot.states())
                .as("the device's acts while the converter is stopped are known")
                .isEqualTo(at("Clean", "Move"));
        assertThat(robot.converter.status().queue().refused()).isZero();

        robot.converter.start();
        assertThat(robot.moves).containsExactly("starts", "ends", "starts");
        robot.arrives();
        assertThat(robot.states()).isEqualTo(at("Spot", "Spot"));
    }

    @Test
    void measuresEveryConversion() throws InterruptedException {
        robot.panel.press("Clean");
        robot.converter.observe(robot.panel);
        robot.clock.advance(Duration.ofMillis(7));
        robot.settle();

        ConverterStatus.ConversionTime time = robot.converter.status().conversionTime();
        assertThat(time).isEqualTo(new ConverterStatus.ConversionTime(1, 7_000_000, 7_000_000, 7_000_000));
        assertThat(List.copyOf(robot.converter.spares())).isEmpty();
    }
}
