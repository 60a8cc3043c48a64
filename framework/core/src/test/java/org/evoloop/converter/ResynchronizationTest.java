package org.evoloop.converter;

import static org.assertj.core.api.Assertions.assertThat;
import static org.evoloop.converter.Robot.at;

import java.time.Duration;
import org.evoloop.converter.recording.Transcript;
import org.evoloop.evolution.Occurrence;
import org.evoloop.evolution.Outcome;
import org.evoloop.statemachine.State;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;

/** The device was unreachable, and is found in an unexpected state. */
class ResynchronizationTest {
    private final LoggedLines transcript = new LoggedLines(Transcript.LOGGER);
    private final Robot robot = new Robot();

    @AfterEach
    void close() {
        robot.close();
        transcript.close();
    }

    @Test
    void bothModelsFollowTheDeviceAndTheTranscriptSaysSo() throws InterruptedException {
        robot.controller("Clean").controller("Clean");
        transcript.lines().clear();

        robot.found("On");

        assertThat(robot.states()).isEqualTo(at("On", "On"));
        assertThat(robot.sent).containsExactly("Clean", "Clean");
        assertThat(robot.settled).endsWith("(Clean, Clean)", "(On, On)");
        assertThat(robot.last().outcome()).isEqualTo(Outcome.HANDLED);
        assertThat(transcript.lines())
                .containsExactly(
                        "----   internal_event : found On   -----",
                        "Monitor",
                        " inputs found On event.",
                        "Analyze",
                        " original_current_state: Clean",
                        " new_current_state: Clean",
                        " mode: Resynchronize",
                        "Plan",
                        " MAPE-K loop does not send events.",
                        "Execute",
                        " original_current_state: On",
                        " new_current_state: On");
    }

    @Test
    void theNewModelStaysWhereItIsIfTheTwoCanStandTogether() throws InterruptedException {
        robot.controller("Clean").controller("Clean").controller("Clean").found("On");
        assertThat(robot.states()).isEqualTo(at("On", "SpotWait"));

        robot.pass(Duration.ofSeconds(5));
        assertThat(robot.states()).isEqualTo(at("On", "On"));
        assertThat(robot.sent).containsExactly("Clean", "Clean");
    }

    @Test
    void aNewFunctionEndsIfItsStateCannotStandTogetherWithWhereTheDeviceIs() throws InterruptedException {
        robot.panel("Clean", true).panel("Spot", false).found("Off");

        assertThat(robot.moves).containsExactly("starts", "ends");
        assertThat(robot.states()).isEqualTo(at("Off", "Off"));
    }

    @Test
    void findingTheDeviceWhereItWasIsNoNews() throws InterruptedException {
        robot.panel("Clean", true);
        transcript.lines().clear();

        robot.found("On");

        assertThat(transcript.lines()).isEmpty();
        assertThat(robot.converter.status().events().handled()).isEqualTo(1);
    }

    @Test
    void aStateThatTheDeviceDoesNotHaveIsNotBelieved() throws InterruptedException {
        robot.panel("Clean", true).found("Flying");

        assertThat(robot.states()).isEqualTo(at("On", "On"));
    }

    @Test
    void aFindingThatIsOlderThanTheLastEventThatWasSentIsStale() throws InterruptedException {
        long before = robot.clock.nanoTime();
        robot.clock.advance(Duration.ofMillis(1));
        robot.controller("Clean");
        robot.converter.offer(new Occurrence.Found(new State("Off"), before));
        robot.converter.step();
        assertThat(robot.states()).isEqualTo(at("On", "On"));
        assertThat(robot.last().outcome()).isEqualTo(Outcome.STALE);
        robot.found("Clean");
        assertThat(robot.states()).isEqualTo(at("Clean", "Clean"));
    }
}
