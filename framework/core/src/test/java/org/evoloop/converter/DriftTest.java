package org.evoloop.converter;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.util.List;
import org.evoloop.PaperModels;
import org.evoloop.converter.recording.DriftWindow;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.State;
import org.evoloop.statemachine.StateMachine;
import org.evoloop.time.ManualClock;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;

/** What the device does that its model does not have is counted. */
class DriftTest {
    private final Robot robot = new Robot();

    @AfterEach
    void close() {
        robot.close();
    }

    private Drift drift() {
        return robot.converter.status().drift();
    }

    @Test
    void whatTheModelHasIsNoDrift() throws InterruptedException {
        robot.panel("Clean", true)
                .controller("Clean")
                .found("Clean")
                .panel("Clean", true)
                .found("On");

        assertThat(drift()).isEqualTo(new Drift(3, List.of()));
        assertThat(drift()).hasToString("");
    }

    @Test
    void anActThatTheModelDoesNotHaveLeadsToWhereTheDeviceIsThen() throws InterruptedException {
        robot.panel("Clean", true).panel("Clean", true).panel("Spot", true).found("On");

        assertThat(drift()).hasToString("1 of the last 3 acts is not in the model: Clean --Spot--> On");
        assertThat(drift().explained(PaperModels.cleaningRobot().original())
                        .nextState(new State("Clean"), new Event("Spot")))
                .contains(new State("On"));
    }

    @Test
    void whereItLeadsIsNotClaimedBeforeTheDeviceHasSaidSo() throws InterruptedException {
        robot.panel("Clean", true).panel("Clean", true).panel("Spot", true);

        assertThat(drift()).hasToString("1 of the last 3 acts is not in the model: Clean --Spot--> ?");
        StateMachine drawn = PaperModels.cleaningRobot().original();
        assertThat(drift().explained(drawn).transitions()).isEqualTo(drawn.transitions());
    }

    @Test
    void anEventThatLeadsElsewhereThanInTheModelIsDrift() throws InterruptedException {
        robot.panel("Clean", true).controller("Clean").found("Spot");

        assertThat(drift()).hasToString("1 of the last 2 acts is not in the model: On --Clean--> Spot");
        StateMachine explained = drift().explained(PaperModels.cleaningRobot().original());
        assertThat(explained.nextState(new State("On"), new Event("Clean"))).contains(new State("Spot"));
        assertThat(explained.transitions())
                .hasSameSizeAs(PaperModels.cleaningRobot().original().transitions());
    }

    @Test
    void aReportFromBeforeTheActIsNotAboutIt() throws InterruptedException {
        robot.panel("Clean", true).controller("Clean").found("On").found("Clean");

        assertThat(drift().unexplained()).isZero();
    }

    @Test
    void aLateReportIsAnActThatNobodyHasSeen() throws InterruptedException {
        robot.panel("Clean", true)
                .controller("Clean")
                .pass(Duration.ofMinutes(10))
                .found("Off");

        assertThat(drift()).hasToString("1 of the last 3 acts is not in the model: Clean --?--> Off");
    }

    @Test
    void whereTheDeviceIsFoundFirstIsNoAct() throws InterruptedException {
        robot.found("Clean");

        assertThat(drift().acts()).isZero();
    }

    @Test
    void onlyTheLastActsCount() {
        DriftWindow window = new DriftWindow(new ManualClock());
        window.acted(new Event("Spot"), new State("Clean"), null);
        for (int i = 0; i < 199; i++) {
            window.acted(new Event("Max"), new State("On"), null);
        }
        assertThat(window.summary())
                .hasToString(
                        "200 of the last 200 acts are not in the model: On --Max--> ? (199), Clean --Spot--> ? (1)");

        window.acted(new Event("Max"), new State("On"), null);

        assertThat(window.summary()).hasToString("200 of the last 200 acts are not in the model: On --Max--> ?");
    }
}
