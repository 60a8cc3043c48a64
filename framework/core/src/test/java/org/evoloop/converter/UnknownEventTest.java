package org.evoloop.converter;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.time.Duration;
import org.evoloop.evolution.Outcome;
import org.evoloop.function.Visit;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;

/** An event that neither model has is reported as unknown, with similar names. */
class UnknownEventTest {
    private final LoggedLines log = new LoggedLines(SystemEventConverter.class.getName());
    private final Robot robot = new Robot();

    @AfterEach
    void close() {
        robot.close();
        log.close();
    }

    @Test
    void aPressIsRefused() {
        assertThatThrownBy(() -> robot.panel.press("Claen"))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessage("unknown event Claen; did you mean Clean?");
        assertThatThrownBy(() -> robot.panel.press("end-spot"))
                .hasMessage("unknown event end-spot; did you mean endSpot?");
        assertThatThrownBy(() -> robot.panel.press("vacuum"))
                .hasMessage("unknown event vacuum; there is Clean, Spot, arriveSpot, endSpot, timeout");
        assertThat(robot.converter.history()).isEmpty();
    }

    @Test
    void unknownEventsOfDeviceAndFunctionsAreLoggedOnceABurst() throws InterruptedException {
        for (int time = 0; time < 5; time++) {
            robot.device("endSpott");
        }
        robot.controller("Clean").controller("Spot");
        Visit visit = robot.moving;
        assertThat(visit).isNotNull();
        visit.raise("arrivespot");
        robot.settle();

        assertThat(log.lines())
                .containsExactly(
                        "unknown event endSpott; did you mean endSpot? (device)",
                        "unknown event arrivespot; did you mean arriveSpot? (function)");
        assertThat(robot.last().outcome()).isEqualTo(Outcome.IGNORED);
        assertThat(robot.last().detail()).isEqualTo("unknown event arrivespot; did you mean arriveSpot?");
        assertThat(robot.converter.status().events().ignored()).isEqualTo(6);
        assertThat(robot.states()).isEqualTo(Robot.at("On", "Move"));
    }

    @Test
    void aFunctionThatWillFinishWithOneIsReportedWhenItSaysSo() throws InterruptedException {
        robot.controller("Clean").controller("Spot");
        Visit visit = robot.moving;
        assertThat(visit).isNotNull();
        assertThatThrownBy(() -> visit.finishAfter(Duration.ofSeconds(5), "timout"))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessage("unknown event timout; did you mean timeout?");
    }

    @Test
    void aStateThatTheDeviceDoesNotHaveIsNamedToo() throws InterruptedException {
        robot.found("clean");
        assertThat(log.lines())
                .containsExactly(
                        "the device was found in clean, which is not a state of its model; did you mean Clean?");
    }
}
