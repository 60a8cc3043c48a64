package org.evoloop.roomba.simulator.robot;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import org.evoloop.roomba.oi.ActuatorCommand.DriveDirect;
import org.evoloop.roomba.oi.Command;
import org.evoloop.roomba.oi.FirmwareVersion;
import org.evoloop.roomba.oi.OiMode;
import org.evoloop.roomba.oi.Packet;
import org.evoloop.roomba.oi.SensorValues;
import org.evoloop.roomba.oi.StreamFrame.Checksum;
import org.evoloop.roomba.oi.StreamFramer;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Faults observed with real robots and cables, each enabled by an option. */
class MisbehaviorTest {
    private static final int TICKS = 2_000;

    private static Bench streaming(RobotOptions.Builder options) {
        return Bench.in(OiMode.PASSIVE, options.build()).stream(Packet.CLIFF_LEFT_SIGNAL, Packet.VIRTUAL_WALL);
    }

    @Test
    void theChecksumOfTheOlderSpecificationLeavesTheHeaderOut() {
        byte[] frame = streaming(RobotOptions.builder().checksum(Checksum.WITHOUT_HEADER))
                .ticks(1)
                .sent();
        int sum = 0;
        for (byte octet : frame) {
            sum += octet;
        }
        assertThat(sum & 0xFF).isEqualTo(19);
        assertThat(streaming(RobotOptions.builder().checksum(Checksum.WITHOUT_HEADER))
                        .ticks(100)
                        .frames())
                .isEmpty();
    }

    @Test
    void theModeCanBeReportedOneTooHigh() {
        Bench bench = Bench.in(OiMode.SAFE, RobotOptions.builder().modeOffset(1).build());
        assertThat(bench.query(Packet.OI_MODE)).isEqualTo(3);
        assertThat(bench.state().oiMode()).isEqualTo(OiMode.SAFE);
    }

    @ParameterizedTest
    @ValueSource(longs = {1, 7, 20_160_810})
    void noiseComesBetweenFramesAndLeavesThemWhole(long seed) {
        byte[] clean = streaming(RobotOptions.builder()).ticks(TICKS).sent();
        byte[] noisy = streaming(RobotOptions.builder().noise(true).seed(seed))
                .ticks(TICKS)
                .sent();
        assertThat(noisy.length - clean.length).as("seed %s", seed).isBetween(TICKS / 10, TICKS / 2);
        int frames = streaming(RobotOptions.builder().noise(true).seed(seed))
                .ticks(TICKS)
                .frames()
                .size();
        assertThat(frames).as("seed %s", seed).isBetween(TICKS * 9 / 10, TICKS);
    }

    @ParameterizedTest
    @ValueSource(longs = {1, 7, 20_160_810})
    void bytesGetLostAndChangedInTheirShareAndTheSameWithTheSameSeed(long seed) {
        byte[] clean = streaming(RobotOptions.builder()).ticks(TICKS).sent();
        RobotOptions.Builder dropping = RobotOptions.builder().dropShare(0.05).seed(seed);
        byte[] dropped = dropped(dropping);
        assertThat(dropped.length).as("seed %s", seed).isCloseTo(clean.length * 95 / 100, within(clean.length / 100));
        assertThat(dropped(dropping)).isEqualTo(dropped);

        byte[] corrupt = dropped(RobotOptions.builder().corruptShare(0.05).seed(seed));
        assertThat(corrupt).as("seed %s", seed).hasSameSizeAs(clean);
        int changed = 0;
        for (int i = 0; i < clean.length; i++) {
            changed += clean[i] == corrupt[i] ? 0 : 1;
        }
        assertThat(changed).as("seed %s", seed).isCloseTo(clean.length / 20, within(clean.length / 100));
    }

    /** What arrives of a stream that is requested until the robot has understood. */
    private static byte[] dropped(RobotOptions.Builder options) {
        Bench bench = new Bench(options.build());
        while (!bench.state().streaming()) {
            // Zeros complete any unfinished command.
            bench.robot.receive(new byte[600], 600);
            bench.send(Bench.START).stream(Packet.CLIFF_LEFT_SIGNAL, Packet.VIRTUAL_WALL);
        }
        bench.ticks(1).sent();
        return bench.ticks(TICKS).sent();
    }

    @Test
    void whatGoesToTheRobotSuffersToo() {
        Bench bench = new Bench(RobotOptions.builder().dropShare(0.5).build());
        int heard = 0;
        for (int i = 0; i < 400; i++) {
            bench.send(Bench.START);
            heard += bench.state().oiMode() == OiMode.PASSIVE ? 1 : 0;
            bench.send(new Command.Stop(), new Command.Stop(), new Command.Stop(), new Command.Stop());
            bench.send(new Command.Stop(), new Command.Stop(), new Command.Stop(), new Command.Stop());
        }
        assertThat(heard).isBetween(150, 250);
    }

    @Test
    void atUnequalRatesBothSidesHearGarbage() {
        Bench bench = streaming(RobotOptions.builder().baud(19_200));
        bench.robot.clientBaud(19_200);
        assertThat(bench.ticks(100).frames()).hasSize(100);
        bench.robot.clientBaud(115_200);
        byte[] garbage = bench.ticks(100).sent();
        assertThat(garbage).as("garbage, not silence").hasSizeGreaterThan(100);
        assertThat(StreamFramer.forAnyPackets().feed(garbage, 0, garbage.length))
                .isEmpty();
        bench.robot.clientBaud(19_200);
        bench.send(new Command.Baud(115_200));
        assertThat(bench.ticks(10).frames()).isEmpty();
        bench.send(Bench.FULL);
        assertThat(bench.state().oiMode()).as("garbage to the robot").isNotEqualTo(OiMode.FULL);
        bench.robot.clientBaud(115_200);
        assertThat(bench.ticks(100).frames()).hasSizeGreaterThan(98);
    }

    @ParameterizedTest
    @ValueSource(strings = {"3.2.6", "3.3.0", "3.4.0", "3.4.1", "3.7.7"})
    void oldFirmwareReportsWrongDistancesAndAngles(String version) {
        FirmwareVersion firmware = FirmwareVersion.parse(version);
        Bench bench =
                Bench.in(OiMode.FULL, RobotOptions.builder().firmware(firmware).build());
        bench.send(new DriveDirect(300, 300)).seconds(10);
        int distanceMm = bench.query(Packet.DISTANCE);
        assertThat(distanceMm)
                .isCloseTo((int) (bench.state().xMm() * (version.equals("3.2.6") ? -1 / 8.0 : 1)), within(1));
        bench.send(new DriveDirect(0, 0)).seconds(1).query(Packet.ANGLE);
        bench.send(new DriveDirect(57, -57)).seconds(5);
        boolean wrong = firmware.compareTo(new FirmwareVersion(3, 4, 0)) <= 0;
        double turnedDeg = 2 * 57 / 235.0 * 180 / Math.PI * 4.98;
        assertThat((double) bench.query(Packet.ANGLE)).isCloseTo(turnedDeg * (wrong ? 0.324056 : 1), within(1.5));
        bench.sent();
        String bootText = bench.send(new Command.Reset()).seconds(4.1).sentText();
        assertThat(FirmwareVersion.find(bootText)).contains(firmware);
        assertThat(bootText.startsWith("bl-start\r\n")).isEqualTo(!version.equals("3.7.7"));
    }

    @Test
    void impossibleOptionsAreRefusedAllAtOnce() {
        assertThatThrownBy(() -> RobotOptions.builder()
                        .spotDurationMillis(7_999)
                        .batteryPercent(0)
                        .baud(19_201)
                        .modeOffset(-1)
                        .dropShare(0.51)
                        .corruptShare(Double.NaN)
                        .build())
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessage("""
                        spot duration is 7999 ms; allowed is 8000 to 600000 ms
                        battery is 0 %; allowed is 1 to 100 %
                        baud is 19201; allowed is one of \
                        [300, 600, 1200, 2400, 4800, 9600, 14400, 19200, 28800, 38400, 57600, 115200]
                        mode offset is -1; allowed is 0 or 1
                        drop is 0.51; allowed is 0 to 0.5
                        corrupt is NaN; allowed is 0 to 0.5""");
    }

    @Test
    void framesSurviveAllOfItTogether() {
        long seed = 42;
        Bench bench = streaming(RobotOptions.builder()
                .noise(true)
                .dropShare(0.001)
                .corruptShare(0.001)
                .seed(seed));
        List<SensorValues> frames = bench.ticks(TICKS).frames();
        assertThat(frames).as("seed %s", seed).hasSizeBetween(TICKS * 8 / 10, TICKS);
        assertThat(frames.stream().filter(frame -> frame.value(Packet.CLIFF_LEFT_SIGNAL) == 2_700))
                .as("seed %s", seed)
                .hasSizeGreaterThan(frames.size() - 5);
    }
}
