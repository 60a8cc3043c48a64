package org.evoloop.roomba.simulator.robot;

import static org.assertj.core.api.Assertions.assertThat;
import static org.evoloop.roomba.oi.OiMode.FULL;
import static org.evoloop.roomba.oi.OiMode.OFF;
import static org.evoloop.roomba.oi.OiMode.PASSIVE;
import static org.evoloop.roomba.oi.OiMode.SAFE;

import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import org.evoloop.roomba.oi.ActuatorCommand;
import org.evoloop.roomba.oi.Button;
import org.evoloop.roomba.oi.Command;
import org.evoloop.roomba.oi.FirmwareVersion;
import org.evoloop.roomba.oi.OiMode;
import org.evoloop.roomba.oi.Opcode;
import org.evoloop.roomba.oi.Packet;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/** The specification's modes, and which commands lead from one to another. */
class ModesTest {
    /**
     * The mode to which each command without data leads from Passive, Safe and Full; only Start and Reset lead out of
     * Off.
     */
    private static final Map<Opcode, OiMode> LEADS_TO = new EnumMap<>(Map.ofEntries(
            Map.entry(Opcode.RESET, OFF),
            Map.entry(Opcode.START, PASSIVE),
            Map.entry(Opcode.CONTROL, SAFE),
            Map.entry(Opcode.SAFE, SAFE),
            Map.entry(Opcode.FULL, FULL),
            Map.entry(Opcode.POWER, PASSIVE),
            Map.entry(Opcode.SPOT, PASSIVE),
            Map.entry(Opcode.CLEAN, PASSIVE),
            Map.entry(Opcode.MAX, PASSIVE),
            Map.entry(Opcode.SEEK_DOCK, PASSIVE),
            Map.entry(Opcode.STOP, OFF)));

    @ParameterizedTest
    @EnumSource
    void everyCommandLeadsWhereTheSpecificationSays(OiMode from) {
        LEADS_TO.forEach((opcode, to) -> {
            Bench bench = Bench.in(from);
            bench.robot.receive(new byte[] {(byte) opcode.code()}, 1);
            boolean ignored = from == OFF && opcode != Opcode.START;
            assertThat(bench.state().oiMode()).as("%s from %s", opcode, from).isEqualTo(ignored ? OFF : to);
        });
    }

    @Test
    void theRobotBeginsInStandbyWithTheInterfaceOff() {
        RobotState state = new Bench().state();
        assertThat(state.activity()).isEqualTo(RobotActivity.OFF);
        assertThat(state.oiMode()).isEqualTo(OFF);
        assertThat(state.timeMillis()).isZero();
    }

    @Test
    void actuatorsMoveInSafeAndFullOnly() {
        for (OiMode mode : OiMode.values()) {
            RobotState state = Bench.in(mode)
                    .send(new ActuatorCommand.DriveDirect(200, 200))
                    .seconds(1)
                    .state();
            boolean controlled = mode == SAFE || mode == FULL;
            assertThat(state.xMm() > 100).as("%s", mode).isEqualTo(controlled);
        }
    }

    @Test
    void anIgnoredCommandsDataIsConsumed() {
        Bench bench = Bench.in(PASSIVE);
        // Each data byte of the ignored Leds would be a command of its own: Reset, Full, Clean.
        byte[] ignored = {(byte) 139, 7, (byte) 132, (byte) 135};
        bench.robot.receive(ignored, ignored.length);
        assertThat(bench.state().oiMode()).isEqualTo(PASSIVE);
        assertThat(bench.state().activity()).isEqualTo(RobotActivity.OFF);
    }

    @Test
    void leavingControlStopsWheelsAndBrushes() {
        List<Command> leavers = List.of(new Command.Start(), new Command.Stop(), new Command.Power());
        for (OiMode mode : List.of(SAFE, FULL)) {
            for (Command leaver : leavers) {
                Bench bench = Bench.in(mode)
                        .send(new ActuatorCommand.DriveDirect(300, 100), new ActuatorCommand.Motors(7))
                        .seconds(1)
                        .send(leaver)
                        .seconds(0.5);
                RobotState stopped = bench.state();
                assertThat(stopped.leftMmPerS()).as("%s", leaver).isZero();
                assertThat(stopped.rightMmPerS()).as("%s", leaver).isZero();
                bench.send(Bench.START);
                assertThat(bench.query(Packet.MAIN_BRUSH_CURRENT)).isZero();
            }
        }
    }

    @Test
    void fromSafeToFullTheRobotDrivesOn() {
        RobotState state = Bench.in(SAFE)
                .send(new ActuatorCommand.DriveDirect(300, 300))
                .seconds(1)
                .send(Bench.FULL)
                .seconds(1)
                .state();
        assertThat(state.leftMmPerS()).isGreaterThan(250);
    }

    @Test
    void resetForgetsAllButTheRobotsPlaceAndPrintsTheFirmwaresVersion() {
        Bench bench = Bench.in(FULL).send(new ActuatorCommand.DriveDirect(300, 300)).seconds(1).stream(Packet.BUTTONS);
        double reachedMm = bench.state().xMm();
        bench.sent();
        bench.send(new Command.Reset());
        assertThat(bench.sentText()).isEqualTo("Soft reset!\r\n");
        assertThat(bench.state().activity()).isEqualTo(RobotActivity.OFF);
        assertThat(bench.state().oiMode()).isEqualTo(OFF);
        bench.send(Bench.START).seconds(3.9);
        bench.robot.press(Button.CLEAN);
        assertThat(bench.sent()).as("the stream has ended, and it boots").isEmpty();
        assertThat(bench.state().oiMode()).as("deaf").isEqualTo(OFF);
        assertThat(bench.state().activity()).as("and blind").isEqualTo(RobotActivity.OFF);
        String text = bench.seconds(0.2).sentText();
        assertThat(text).startsWith("\u00feRoomba by iRobot!\r\n");
        assertThat(FirmwareVersion.find(text)).contains(new FirmwareVersion(3, 7, 7));
        assertThat(bench.state().xMm()).isBetween(reachedMm, reachedMm + 60);
        assertThat(bench.state().leftMmPerS()).isZero();
        bench.send(Bench.START);
        assertThat(bench.query(Packet.LEFT_ENCODER)).isBetween(0, 130);
        assertThat(bench.query(Packet.REQUESTED_LEFT_VELOCITY)).isZero();
    }

    @Test
    void inOffTheRobotIsSilent() {
        Bench bench = Bench.in(PASSIVE).stream(Packet.BUTTONS).send(new Command.Stop());
        bench.sent();
        byte[] query = {(byte) 142, 35};
        bench.robot.receive(query, query.length);
        bench.seconds(1);
        assertThat(bench.sent()).isEmpty();
        bench.send(Bench.START).seconds(1);
        assertThat(bench.sent()).as("the stream does not come back by itself").isEmpty();
    }

    @Test
    void aPressUnderControlIsOnlyReported() {
        for (OiMode mode : List.of(SAFE, FULL)) {
            for (Button button : Button.values()) {
                Bench bench = Bench.in(mode);
                bench.robot.press(button);
                assertThat(bench.state().activity()).isEqualTo(RobotActivity.ON);
                assertThat(bench.state().oiMode()).isEqualTo(mode);
                assertThat(bench.query(Packet.BUTTONS)).isEqualTo(1 << button.bit());
            }
        }
    }
}
