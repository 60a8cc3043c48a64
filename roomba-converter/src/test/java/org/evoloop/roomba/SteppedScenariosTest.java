package org.evoloop.roomba;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;
import static org.evoloop.roomba.SteppedRoomba.at;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import org.evoloop.converter.HistoryEntry;
import org.evoloop.evolution.Outcome;
import org.evoloop.roomba.oi.Button;
import org.evoloop.roomba.oi.OiMode;
import org.evoloop.roomba.simulator.robot.RobotActivity;
import org.evoloop.roomba.simulator.robot.RobotState;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;

/** The demo's scenarios, with the same code but without threads, ports and real time. */
class SteppedScenariosTest {
    private static final Duration SOON = Duration.ofMillis(500);

    private final SteppedRoomba roomba = new SteppedRoomba();

    @AfterEach
    void close() {
        roomba.close();
    }

    private void assertTruth(RobotActivity activity, OiMode mode) {
        roomba.advance(SOON);
        RobotState truth = roomba.truth();
        assertThat(truth.activity()).isEqualTo(activity);
        assertThat(truth.oiMode()).isEqualTo(mode);
    }

    private void assertNear(double xMm, double yMm, double toleranceMm) {
        assertThat(Math.hypot(roomba.truth().xMm() - xMm, roomba.truth().yMm() - yMm))
                .isCloseTo(0, within(toleranceMm));
    }

    @Test
    void remoteStart() {
        roomba.robotPress(Button.CLEAN);
        assertThat(roomba.states()).isEqualTo(at("On", "On"));
        assertTruth(RobotActivity.ON, OiMode.SAFE);

        roomba.robotPress(Button.SPOT);
        assertThat(roomba.states()).isEqualTo(at("On", "Move"));
        roomba.until(() -> roomba.states().equals(at("Spot", "Spot")), Duration.ofSeconds(20));
        assertNear(1000, 500, 30);
        assertTruth(RobotActivity.SPOT, OiMode.PASSIVE);

        roomba.until(() -> roomba.states().equals(at("On", "On")), Duration.ofSeconds(60));
        assertTruth(RobotActivity.ON, OiMode.SAFE);
        assertNear(1000, 500, 60);
        assertThat(roomba.roomba.converter().history())
                .extracting(HistoryEntry::detail)
                .satisfiesExactly(
                        switchedOn -> assertThat(switchedOn).isEqualTo("Clean (by the device)"),
                        started -> assertThat(started).isEqualTo("new function of Move"),
                        arrived -> assertThat(arrived)
                                .matches("Spot; left Move at checking the place, distance 0[.0-9]* m, .*"),
                        ended -> assertThat(ended).isEqualTo("endSpot (by the device)"));
    }

    private void startCleaning() {
        roomba.press("Clean");
        assertThat(roomba.states()).isEqualTo(at("On", "On"));
        assertTruth(RobotActivity.ON, OiMode.SAFE);
        roomba.press("Clean");
        assertThat(roomba.states()).isEqualTo(at("Clean", "Clean"));
        assertTruth(RobotActivity.CLEAN, OiMode.PASSIVE);
    }

    @Test
    void spotFromClean() {
        startCleaning();
        roomba.press("Clean");
        assertThat(roomba.states()).isEqualTo(at("Clean", "SpotWait"));
        assertTruth(RobotActivity.CLEAN, OiMode.PASSIVE);
        roomba.press("Clean");
        assertThat(roomba.states()).isEqualTo(at("Spot", "Spot"));
        assertTruth(RobotActivity.SPOT, OiMode.PASSIVE);
        assertThat(roomba.last().detail()).isEqualTo("Clean, Spot");
    }

    @Test
    void ownButton() {
        startCleaning();
        roomba.robotPress(Button.CLEAN);
        assertThat(roomba.states()).isEqualTo(at("On", "SpotWait"));
        assertTruth(RobotActivity.ON, OiMode.SAFE);
        roomba.robotPress(Button.CLEAN);
        assertThat(roomba.states()).isEqualTo(at("Spot", "Spot"));
        assertTruth(RobotActivity.SPOT, OiMode.PASSIVE);
    }

    @Test
    void timeout() {
        startCleaning();
        roomba.press("Clean").advance(Duration.ofMillis(4_900));
        assertThat(roomba.states()).isEqualTo(at("Clean", "SpotWait"));
        assertTruth(RobotActivity.ON, OiMode.SAFE);
        assertThat(roomba.states()).isEqualTo(at("On", "On"));
    }

    @Test
    void theSameRunsTheSameWay() {
        List<List<RobotState>> runs = new ArrayList<>();
        for (int run = 0; run < 2; run++) {
            try (SteppedRoomba repeated = new SteppedRoomba()) {
                List<RobotState> truths = new ArrayList<>();
                repeated.robotPress(Button.CLEAN).robotPress(Button.SPOT);
                while (!repeated.states().equals(at("On", "On"))) {
                    repeated.advance(Duration.ofMillis(15));
                    truths.add(repeated.truth());
                }
                runs.add(truths);
            }
        }
        assertThat(runs.get(0)).hasSizeGreaterThan(3_000).isEqualTo(runs.get(1));
    }

    @Test
    void closingInTheMiddleOfMoveLeavesTheRobotStandingAndToItself() {
        roomba.robotPress(Button.CLEAN).robotPress(Button.SPOT).advance(Duration.ofSeconds(2));
        assertThat(roomba.truth().rightMmPerS()).isPositive();
        roomba.close();
        for (int ticks = 0; ticks < 100; ticks++) {
            roomba.robot.tick();
        }
        assertThat(roomba.truth())
                .extracting(RobotState::oiMode, RobotState::leftMmPerS, RobotState::rightMmPerS)
                .containsExactly(OiMode.PASSIVE, 0.0, 0.0);
    }

    @Test
    void aPulledCableFailsEventsAndShowsInTheStatus() {
        roomba.press("Clean");
        roomba.advance(SOON);
        roomba.unplug();
        roomba.press("Clean");
        assertThat(roomba.last().outcome()).isEqualTo(Outcome.FAILED);
        assertThat(roomba.states()).isEqualTo(at("On", "On"));
        assertThat(roomba.roomba.converter().status().link().up()).isFalse();
        assertThat(roomba.roomba.converter().status().link().text())
                .as("it names the port once")
                .isEqualTo("memory link of the converter hung up");
        assertThat(roomba.last().detail()).endsWith(": memory link of the converter hung up");
    }

    @Test
    void aCablePulledBeforeACommandShowsItsEffectLeavesTheRecordInDoubtUntilTheRobotIsBack() {
        roomba.press("Clean");
        roomba.advance(SOON);
        roomba.unplugWithTheNextCommand();
        roomba.press("Clean");
        assertThat(roomba.truth().activity()).isEqualTo(RobotActivity.CLEAN);
        assertThat(roomba.roomba.converter().status().doubt())
                .contains("it is unknown whether Clean had its effect")
                .contains("hung up");

        roomba.replug();
        roomba.advance(Duration.ofSeconds(2));
        assertThat(roomba.roomba.converter().status().doubt()).isEmpty();
        assertThat(roomba.states()).isEqualTo(at("On", "On"));
        assertTruth(RobotActivity.ON, OiMode.SAFE);
    }

    @Test
    void aSilentRobotIsSentNoEvents() {
        roomba.press("Clean");
        roomba.advance(SOON);
        roomba.mute(true).advance(Duration.ofMillis(2_500));
        roomba.robotPress(Button.CLEAN);
        assertTruth(RobotActivity.CLEAN, OiMode.PASSIVE);

        roomba.press("Clean");
        assertThat(roomba.last().outcome()).isEqualTo(Outcome.FAILED);
        assertThat(roomba.last().detail()).contains("the robot has fallen silent");
        assertThat(roomba.truth().activity()).as("not paused").isEqualTo(RobotActivity.CLEAN);

        roomba.mute(false).advance(Duration.ofSeconds(2));
        assertThat(roomba.states()).isEqualTo(at("On", "On"));
        assertTruth(RobotActivity.ON, OiMode.SAFE);
    }
}
