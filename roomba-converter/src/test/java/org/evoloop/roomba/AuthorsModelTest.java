package org.evoloop.roomba;

import static org.assertj.core.api.Assertions.assertThat;
import static org.evoloop.roomba.SteppedRoomba.at;

import java.nio.file.Path;
import java.time.Duration;
import org.evoloop.AuthorsPair;
import org.evoloop.evolution.ModelPair;
import org.evoloop.roomba.move.MoveOptions;
import org.evoloop.roomba.move.StartPointSensor;
import org.evoloop.roomba.oi.Button;
import org.evoloop.roomba.simulator.robot.RobotActivity;
import org.evoloop.roomba.simulator.robot.RobotOptions;
import org.evoloop.xmi.ModelFile;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;

/** The robot runs with a model drawn as by the paper's authors. */
@Timeout(180)
class AuthorsModelTest {
    @TempDir
    Path folder;

    private SteppedRoomba roomba() throws Exception {
        ModelFile file = ModelFile.read(AuthorsPair.write(folder.resolve("robot.xml")));
        return new SteppedRoomba(
                RobotOptions.defaults(),
                new ModelPair(file.pick("original"), file.pick("new")),
                MoveOptions.defaults(),
                (robot, clock) -> StartPointSensor.byWheels(1_000, 500));
    }

    @Test
    void moveRunsInTheStateThatArriveSpotLeaves() throws Exception {
        try (SteppedRoomba roomba = roomba()) {
            roomba.robotPress(Button.CLEAN).robotPress(Button.SPOT);
            assertThat(roomba.states()).isEqualTo(at("On", "MoveToStartPoint"));
            roomba.until(() -> roomba.states().equals(at("Spot", "Spot")), Duration.ofSeconds(20));
            assertThat(Math.hypot(roomba.truth().xMm() - 1_000, roomba.truth().yMm() - 500))
                    .isLessThan(30);
        }
    }

    @Test
    void theTimeOfSpotWaitIsThatOfTheModel() throws Exception {
        try (SteppedRoomba roomba = roomba()) {
            roomba.press(RobotEvents.CLEAN).advance(Duration.ofSeconds(1)).press(RobotEvents.CLEAN);
            roomba.advance(Duration.ofSeconds(1)).press(RobotEvents.CLEAN);
            assertThat(roomba.states()).isEqualTo(at("Clean", "SpotWait"));
            roomba.advance(Duration.ofMillis(1_900));
            assertThat(roomba.states()).isEqualTo(at("Clean", "SpotWait"));
            roomba.advance(Duration.ofMillis(700));
            assertThat(roomba.states()).isEqualTo(at("On", "On"));
            assertThat(roomba.truth().activity()).isEqualTo(RobotActivity.ON);
        }
    }

    @Test
    @EnabledOnOs(OS.LINUX)
    void atTheCommandLine() throws Exception {
        Path file = AuthorsPair.write(folder.resolve("robot.xml"));
        String[] models = {"--simulate", "--speed", "20", "--original", file + "#original", "--new", file + "#new"};
        Program.Result result = Program.runWithInput(folder, "start\nstatus\nexit\n", models);
        assertThat(result.err()).isEmpty();
        assertThat(result.out()).contains("original Off, new Off");
        assertThat(result.status()).isZero();

        Program.Result twice = Program.runWithInput(
                folder,
                "",
                "--simulate",
                "--models",
                file.toString(),
                "--spot-wait",
                "3",
                "--function",
                "SpotWait=SpotWait");
        assertThat(twice.err())
                .isEqualTo("error: --spot-wait says how long SpotWait lasts, but no state of the new model is left by "
                        + "timeout; leave the option out, a time trigger such as tm(2s) is in the model\n");
        assertThat(twice.status()).isEqualTo(2);
    }
}
