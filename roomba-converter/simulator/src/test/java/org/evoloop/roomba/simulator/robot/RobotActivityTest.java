package org.evoloop.roomba.simulator.robot;

import static org.assertj.core.api.Assertions.assertThat;
import static org.evoloop.roomba.simulator.robot.RobotActivity.CLEAN;
import static org.evoloop.roomba.simulator.robot.RobotActivity.DOCK;
import static org.evoloop.roomba.simulator.robot.RobotActivity.OFF;
import static org.evoloop.roomba.simulator.robot.RobotActivity.ON;
import static org.evoloop.roomba.simulator.robot.RobotActivity.SPOT;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Set;
import org.evoloop.roomba.oi.ActuatorCommand;
import org.evoloop.roomba.oi.Button;
import org.evoloop.roomba.oi.Command;
import org.evoloop.roomba.oi.OiMode;
import org.evoloop.roomba.oi.Packet;
import org.evoloop.roomba.oi.SensorValues;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;

/** What the robot does by itself, by its buttons and by commands. */
class RobotActivityTest {

    /** A robot in Passive mode that does this. */
    private static Bench doing(RobotActivity activity) {
        Bench bench = Bench.in(OiMode.PASSIVE);
        switch (activity) {
            case OFF -> {}
            case ON -> bench.send(Bench.SAFE, Bench.START);
            case CLEAN -> bench.send(new Command.Clean());
            case SPOT -> bench.send(new Command.Spot());
            case DOCK -> bench.send(new Command.SeekDock());
        }
        assertThat(bench.state().activity()).isEqualTo(activity);
        assertThat(bench.state().oiMode()).isEqualTo(OiMode.PASSIVE);
        return bench.seconds(1);
    }

    @ParameterizedTest
    @CsvSource({
        "OFF,   CLEAN, ON", "OFF,   SPOT, OFF", "OFF,   DOCK, OFF",
        "ON,    CLEAN, CLEAN", "ON,    SPOT, SPOT", "ON,    DOCK, DOCK",
        "CLEAN, CLEAN, ON", "CLEAN, SPOT, ON", "CLEAN, DOCK, ON",
        "SPOT,  CLEAN, ON", "SPOT,  SPOT, ON", "SPOT,  DOCK, ON",
        "DOCK,  CLEAN, ON", "DOCK,  SPOT, ON", "DOCK,  DOCK, ON",
        "ON,    CLOCK, ON", "CLEAN, MINUTE, CLEAN"
    })
    void aButtonLeadsTheRobotOn(RobotActivity from, Button button, RobotActivity to) {
        Bench pressed = doing(from);
        pressed.robot.press(button);
        assertThat(pressed.state().activity()).isEqualTo(to);
        assertThat(pressed.state().oiMode()).isEqualTo(OiMode.PASSIVE);

        Bench commanded = doing(from).send(new ActuatorCommand.Buttons(Set.of(button)));
        assertThat(commanded.state().activity()).as("by command Buttons").isEqualTo(to);

        Bench interfaceOff = doing(from).send(new Command.Stop());
        interfaceOff.robot.press(button);
        assertThat(interfaceOff.state().activity()).as("in mode Off").isEqualTo(to);
        assertThat(interfaceOff.state().oiMode()).isEqualTo(OiMode.OFF);
    }

    @ParameterizedTest
    @EnumSource
    void aCleaningCommandStartsAlsoFromStandbyAndPausesARunningCleaning(RobotActivity from) {
        boolean pauses = from.isRunning();
        List<Command> commands =
                List.of(new Command.Clean(), new Command.Max(), new Command.Spot(), new Command.SeekDock());
        List<RobotActivity> started = List.of(CLEAN, CLEAN, SPOT, DOCK);
        for (int i = 0; i < commands.size(); i++) {
            Bench bench = doing(from).send(commands.get(i));
            assertThat(bench.state().activity())
                    .as("%s while %s", commands.get(i), from)
                    .isEqualTo(pauses ? ON : started.get(i));
            assertThat(bench.state().oiMode()).isEqualTo(OiMode.PASSIVE);
        }
    }

    @ParameterizedTest
    @EnumSource
    void controlTurnsTheRobotOnAndEndsWhatItDid(RobotActivity from) {
        for (Command command : List.of(new Command.Safe(), new Command.Control(), new Command.Full())) {
            Bench bench = doing(from).send(command);
            assertThat(bench.state().activity()).isEqualTo(ON);
            bench.seconds(0.5);
            assertThat(bench.state().leftMmPerS()).isZero();
            assertThat(bench.query(Packet.SIDE_BRUSH_CURRENT)).isZero();
        }
    }

    @ParameterizedTest
    @EnumSource
    void powerLeadsToStandby(RobotActivity from) {
        Bench bench = doing(from).send(new Command.Power()).seconds(0.5);
        assertThat(bench.state().activity()).isEqualTo(OFF);
        assertThat(bench.state().oiMode()).isEqualTo(OiMode.PASSIVE);
        assertThat(bench.state().leftMmPerS()).isZero();
    }

    @ParameterizedTest
    @EnumSource
    void startAndStopLeaveWhatTheRobotDoesAlone(RobotActivity from) {
        assertThat(doing(from).send(Bench.START).state().activity()).isEqualTo(from);
        assertThat(doing(from).send(new Command.Stop(), Bench.START).state().activity())
                .isEqualTo(from);
    }

    @Test
    void theFrameThatFirstShowsAPressShowsTheCurrentsOfWhatItBegan() {
        Bench bench = doing(ON).stream(Packet.BUTTONS, Packet.OI_MODE, Packet.SIDE_BRUSH_CURRENT);
        bench.robot.press(Button.SPOT, 100);
        List<SensorValues> frames = bench.ticks(9).frames();
        assertThat(frames).hasSize(9);
        for (int i = 0; i < 9; i++) {
            assertThat(frames.get(i).isPressed(Button.SPOT)).as("frame %s", i).isEqualTo(i < 7);
            assertThat(frames.get(i).mode()).contains(OiMode.PASSIVE);
            assertThat(frames.get(i).sideBrushMilliAmps()).isPositive();
        }
    }

    @Test
    void aCommandedPressLastsASixthOfASecond() {
        Bench bench = doing(ON).stream(Packet.BUTTONS).send(new ActuatorCommand.Buttons(Set.of(Button.CLEAN)));
        List<SensorValues> frames = bench.ticks(20).frames();
        assertThat(frames.stream().filter(frame -> frame.isPressed(Button.CLEAN)))
                .hasSize(12);
    }

    @Test
    void aButtonThatAClientHoldsDownActsOnce() {
        Bench bench = doing(ON).stream(Packet.BUTTONS);
        for (int commands = 0; commands < 10; commands++) {
            bench.send(new ActuatorCommand.Buttons(Set.of(Button.CLEAN))).ticks(5);
        }
        assertThat(bench.state().activity()).isEqualTo(CLEAN);
        assertThat(bench.frames()).hasSize(50).allMatch(frame -> frame.isPressed(Button.CLEAN));
        assertThat(bench.ticks(7).state().pressed()).isEmpty();
    }

    @Test
    void aHeldButtonActsOnce() {
        Bench bench = doing(ON);
        bench.robot.press(Button.CLEAN, 3_000);
        assertThat(bench.seconds(2.9).state().activity()).isEqualTo(CLEAN);
        assertThat(bench.state().pressed()).containsExactly(Button.CLEAN);
        assertThat(bench.seconds(0.2).state().activity()).isEqualTo(CLEAN);
        assertThat(bench.state().pressed()).isEmpty();
    }

    @Test
    void aPressWhileTheButtonIsDownIsAnotherOneOnceItIsUpAgain() {
        Bench bench = doing(ON).stream(Packet.BUTTONS);
        bench.robot.press(Button.CLEAN, 150);
        bench.robot.press(Button.CLEAN, 300);
        assertThat(bench.ticks(10 + ButtonPanel.RELEASED_TICKS - 1).state().activity())
                .isEqualTo(CLEAN);
        assertThat(bench.ticks(1).state().activity()).as("paused by the second").isEqualTo(ON);
        List<Boolean> seen = bench.ticks(30).frames().stream()
                .map(frame -> frame.isPressed(Button.CLEAN))
                .toList();
        List<Boolean> expected = new ArrayList<>(Collections.nCopies(10, true));
        expected.addAll(Collections.nCopies(ButtonPanel.RELEASED_TICKS, false));
        expected.addAll(Collections.nCopies(20, true));
        expected.addAll(Collections.nCopies(10, false));
        assertThat(seen).isEqualTo(expected);
        bench.robot.press(Button.CLEAN);
        assertThat(bench.state().activity()).as("no wait any more").isEqualTo(CLEAN);
    }

    @Test
    void spotLastsItsTimeEndsByItselfAndWhereItBegan() {
        for (int durationMillis : new int[] {RobotOptions.SHORTEST_SPOT_MILLIS, 20_000, 45_000, 90_000}) {
            Bench bench = new Bench(
                    RobotOptions.builder().spotDurationMillis(durationMillis).build());
            bench.send(Bench.START, Bench.SAFE, new ActuatorCommand.DriveDirect(200, 100))
                    .seconds(3)
                    .send(new ActuatorCommand.DriveDirect(0, 0))
                    .seconds(1);
            RobotState start = bench.state();
            bench.send(new Command.Spot());
            double farthestMm = 0;
            long ticks = 0;
            while (bench.state().activity() == SPOT) {
                bench.ticks(1);
                ticks++;
                farthestMm = Math.max(farthestMm, distanceMm(start, bench.state()));
            }
            assertThat(ticks).isEqualTo((durationMillis + 14) / 15);
            assertThat(farthestMm).as("radius in %s ms", durationMillis).isBetween(430.0, 530.0);
            bench.seconds(0.5);
            RobotState end = bench.state();
            assertThat(distanceMm(start, end)).as("in %s ms", durationMillis).isLessThan(20);
            assertThat(end.activity()).isEqualTo(ON);
            assertThat(end.oiMode()).isEqualTo(OiMode.PASSIVE);
            assertThat(end.leftMmPerS()).isZero();
            assertThat(end.rightMmPerS()).isZero();
        }
    }

    private static double distanceMm(RobotState from, RobotState to) {
        return Math.hypot(to.xMm() - from.xMm(), to.yMm() - from.yMm());
    }

    @Test
    void cleaningCoversGroundAndNeverEndsByItself() {
        Bench bench = doing(CLEAN);
        double farthestMm = 0;
        for (int second = 0; second < 600; second++) {
            bench.seconds(1);
            farthestMm = Math.max(
                    farthestMm, Math.hypot(bench.state().xMm(), bench.state().yMm()));
        }
        assertThat(bench.state().activity()).isEqualTo(CLEAN);
        assertThat(farthestMm).isBetween(800.0, 5_000.0);
    }

    @Test
    void whatTheRobotDoesShowsInItsCurrentsAndWheels() {
        for (RobotActivity activity : List.of(CLEAN, SPOT)) {
            Bench bench = doing(activity).stream(
                    Packet.CURRENT,
                    Packet.LEFT_MOTOR_CURRENT,
                    Packet.RIGHT_MOTOR_CURRENT,
                    Packet.MAIN_BRUSH_CURRENT,
                    Packet.SIDE_BRUSH_CURRENT,
                    Packet.STASIS);
            List<SensorValues> frames = bench.seconds(10).frames();
            assertThat(frames).allSatisfy(frame -> {
                assertThat(frame.currentMilliAmps()).isBetween(-1_600, -700);
                assertThat(frame.value(Packet.LEFT_MOTOR_CURRENT) + frame.value(Packet.RIGHT_MOTOR_CURRENT))
                        .isPositive();
                assertThat(frame.mainBrushMilliAmps()).isBetween(300, 600);
                assertThat(frame.sideBrushMilliAmps()).isBetween(50, 150);
            });
            assertThat(frames.stream().map(frame -> frame.value(Packet.STASIS)).distinct())
                    .containsExactlyInAnyOrder(0, 1);
        }
    }

    @Test
    void aRobotAtRestIsQuiet() {
        Bench bench = doing(ON).stream(
                Packet.CURRENT,
                Packet.LEFT_ENCODER,
                Packet.LEFT_MOTOR_CURRENT,
                Packet.MAIN_BRUSH_CURRENT,
                Packet.SIDE_BRUSH_CURRENT,
                Packet.STASIS);
        List<SensorValues> frames = bench.seconds(10).frames();
        assertThat(frames.stream().distinct()).hasSize(1);
        assertThat(frames.get(0).currentMilliAmps()).isEqualTo(-200);
        assertThat(frames.get(0).mainBrushMilliAmps()).isZero();
        assertThat(frames.get(0).sideBrushMilliAmps()).isZero();
    }
}
