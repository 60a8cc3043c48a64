package org.evoloop.roomba.simulator.robot;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Optional;
import java.util.regex.Pattern;
import org.evoloop.roomba.oi.ChargingState;
import org.evoloop.roomba.oi.Command;
import org.evoloop.roomba.oi.OiMode;
import org.evoloop.roomba.oi.Packet;
import org.evoloop.roomba.oi.PacketGroup;
import org.evoloop.roomba.oi.SensorValues;
import org.evoloop.roomba.simulator.room.Pose;
import org.evoloop.roomba.simulator.room.Room;
import org.junit.jupiter.api.Test;

/** Battery, dock, and the text sent while charging. */
class ChargingTest {
    private static final Pattern LINE = Pattern.compile(
            "bat:   min \\d+  sec \\d+  mV \\d{5}  mA \\d+" + "  tenths-deg-C \\d+  mAH \\d+  state \\d  \r\n");

    private static Bench docked(int batteryPercent) {
        Bench bench = Bench.in(
                OiMode.PASSIVE,
                RobotOptions.builder().batteryPercent(batteryPercent).build());
        bench.robot.dock();
        return bench.ticks(2);
    }

    private static SensorValues all(Bench bench) {
        return bench.stream(PacketGroup.GROUP_100).ticks(1).frames().get(0);
    }

    @Test
    void onTheDockTheBatteryFillsThenTrickles() {
        Bench bench = docked(90);
        SensorValues charging = all(bench);
        assertThat(charging.chargingState()).contains(ChargingState.FULL_CHARGING);
        assertThat(charging.onHomeBase()).isTrue();
        assertThat(charging.onInternalCharger()).isFalse();
        assertThat(charging.currentMilliAmps()).isEqualTo(1_000);
        assertThat(bench.state().charging()).isTrue();
        bench.stream().seconds(600);
        SensorValues later = all(bench);
        assertThat(later.batteryChargeMilliAmpHours() - charging.batteryChargeMilliAmpHours())
                .isBetween(160, 170);
        assertThat(later.voltageMilliVolts()).isGreaterThan(charging.voltageMilliVolts());
        SensorValues full = all(bench.stream().seconds(600));
        assertThat(full.chargingState()).contains(ChargingState.TRICKLE_CHARGING);
        assertThat(full.currentMilliAmps()).isBetween(1, 100);
        assertThat(bench.state().batteryPercent()).isEqualTo(100);
    }

    @Test
    void fullModeEndsCharging() {
        Bench bench = docked(90).send(Bench.FULL).ticks(1);
        SensorValues values = all(bench);
        assertThat(values.chargingState()).contains(ChargingState.NOT_CHARGING);
        assertThat(values.onHomeBase()).as("the contacts still have current").isTrue();
        assertThat(values.currentMilliAmps()).isNegative();
        bench.send(Bench.START).ticks(1);
        assertThat(all(bench).chargingState()).contains(ChargingState.FULL_CHARGING);
    }

    @Test
    void chargingPrintsALineASecondAmongTheFrames() {
        Bench bench = docked(50);
        bench.sent();
        String text = bench.seconds(10).sentText();
        assertThat(text.lines()).hasSize(10);
        assertThat(text).matches("(" + LINE.pattern() + ")+");
        List<SensorValues> frames = bench.stream(Packet.OI_MODE).seconds(10).frames();
        assertThat(frames).hasSize(667);
        bench.robot.undock();
        bench.stream().ticks(1);
        bench.sent();
        assertThat(bench.seconds(10).sent()).isEmpty();
    }

    @Test
    void cleaningLeavesTheDockAndEndsWhenItIsPutBack() {
        Bench bench = docked(90).send(new Command.Clean()).seconds(10);
        assertThat(bench.state().activity()).isEqualTo(RobotActivity.CLEAN);
        assertThat(bench.state().surroundings().docked()).isFalse();
        assertThat(bench.state().charging()).isFalse();
        bench.robot.dock();
        assertThat(bench.ticks(1).state().activity()).isEqualTo(RobotActivity.ON);
        assertThat(bench.ticks(1).state().charging()).isTrue();
    }

    @Test
    void undockedItDoesNotCharge() {
        Bench bench = docked(50);
        bench.robot.undock();
        bench.ticks(1);
        SensorValues values = all(bench);
        assertThat(values.chargingState()).isEqualTo(Optional.of(ChargingState.NOT_CHARGING));
        assertThat(values.onHomeBase()).isFalse();
        assertThat(values.value(Packet.INFRARED_OMNI)).as("the beams reach it").isEqualTo(173);
        bench.robot.place(new Pose(-400, 0, Math.PI));
        assertThat(all(bench).value(Packet.INFRARED_OMNI)).isNotZero();
        bench.robot.place(new Pose(600, 0, 0));
        assertThat(all(bench).value(Packet.INFRARED_OMNI)).as("behind the dock").isZero();
    }

    @Test
    void cleaningEndsWhenTheBatteryIsLowAndMaxWhenItIsEmpty() {
        RobotOptions almostLow = RobotOptions.builder().batteryPercent(11).build();
        Bench cleaning = Bench.in(OiMode.PASSIVE, almostLow).send(new Command.Clean());
        while (cleaning.ticks(1).state().activity() == RobotActivity.CLEAN) {
            assertThat(cleaning.state().batteryPercent()).isGreaterThanOrEqualTo(10);
        }
        assertThat(cleaning.state().activity()).isEqualTo(RobotActivity.ON);
        assertThat(cleaning.state().batteryPercent()).isEqualTo(10);
        Bench max = Bench.in(OiMode.PASSIVE, almostLow).send(new Command.Max());
        while (max.ticks(1).state().activity() == RobotActivity.CLEAN) {
            assertThat(max.state().asleep()).isFalse();
        }
        assertThat(max.state().batteryPercent()).isZero();
        assertThat(max.state().asleep()).isTrue();
        max.sent();
        assertThat(max.pulse(500).seconds(5).sent()).as("without power").isEmpty();
        max.robot.dock();
        assertThat(max.ticks(1).state().asleep()).isFalse();
    }

    @Test
    void withADockLowCleaningGoesHome() {
        Room room = Room.OPEN.withDock(new Pose(-1_500, 0, Math.PI));
        Bench bench = Bench.in(
                        OiMode.PASSIVE,
                        RobotOptions.builder().room(room).batteryPercent(10).build())
                .send(new Command.Clean())
                .ticks(5);
        assertThat(bench.state().activity()).isEqualTo(RobotActivity.DOCK);
        for (int second = 0; second < 300 && bench.state().activity() == RobotActivity.DOCK; second++) {
            bench.seconds(1);
        }
        assertThat(bench.state().activity()).isEqualTo(RobotActivity.ON);
        assertThat(bench.seconds(1).state().charging()).isTrue();
        assertThat(bench.state().leftMmPerS()).isZero();
    }
}
