package org.evoloop.roomba.simulator.robot;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;
import static org.quicktheories.QuickTheory.qt;
import static org.quicktheories.generators.SourceDSL.longs;

import java.util.Collections;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import org.evoloop.roomba.oi.ActuatorCommand.Motors;
import org.evoloop.roomba.oi.ActuatorCommand.Play;
import org.evoloop.roomba.oi.ActuatorCommand.PwmMotors;
import org.evoloop.roomba.oi.ActuatorCommand.Song;
import org.evoloop.roomba.oi.Button;
import org.evoloop.roomba.oi.Command;
import org.evoloop.roomba.oi.InputCommand.PauseResumeStream;
import org.evoloop.roomba.oi.InputCommand.QueryList;
import org.evoloop.roomba.oi.InputCommand.Sensors;
import org.evoloop.roomba.oi.OiMode;
import org.evoloop.roomba.oi.Packet;
import org.evoloop.roomba.oi.PacketGroup;
import org.evoloop.roomba.oi.SensorValues;
import org.junit.jupiter.api.Test;

/** Queries, streams and the values of packets. */
class ReportsTest {

    @Test
    void everyTickSendsOneFrame() {
        Bench bench = Bench.in(OiMode.PASSIVE).stream(Packet.CLIFF_LEFT_SIGNAL, Packet.VIRTUAL_WALL);
        assertThat(bench.sent()).as("before the first tick").isEmpty();
        assertThat(bench.ticks(200).sent()).hasSize(200 * 8);
        assertThat(bench.ticks(1).sent()).startsWith(19, 5, 28).hasSize(8);
    }

    @Test
    void aStreamCanBePausedResumedReplacedAndEnded() {
        Bench bench = Bench.in(OiMode.PASSIVE).stream(Packet.BUTTONS, PacketGroup.GROUP_3);
        assertThat(bench.query(Packet.NUMBER_OF_STREAM_PACKETS)).isEqualTo(2);
        bench.send(new PauseResumeStream(false));
        assertThat(bench.ticks(10).frames()).isEmpty();
        assertThat(bench.state().streaming()).isFalse();
        bench.send(new PauseResumeStream(true));
        assertThat(bench.ticks(10).frames())
                .hasSize(10)
                .allMatch(frame -> frame.has(Packet.VOLTAGE) && frame.has(Packet.BUTTONS));
        bench.send(new PauseResumeStream(false)).stream(Packet.OI_MODE);
        assertThat(bench.ticks(10).frames())
                .hasSize(10)
                .allMatch(frame -> frame.mode().equals(Optional.of(OiMode.PASSIVE)));
        bench.stream();
        assertThat(bench.ticks(10).sent()).isEmpty();
        bench.send(new PauseResumeStream(true));
        assertThat(bench.ticks(10).sent()).isEmpty();
    }

    @Test
    void theStreamOutlivesChangesOfMode() {
        Bench bench = Bench.in(OiMode.PASSIVE).stream(Packet.OI_MODE);
        List<SensorValues> frames = bench.ticks(1)
                .send(Bench.SAFE)
                .ticks(1)
                .send(Bench.FULL)
                .ticks(1)
                .send(Bench.START)
                .ticks(1)
                .frames();
        assertThat(frames).extracting(frame -> frame.value(Packet.OI_MODE)).containsExactly(1, 2, 3, 1);
    }

    @Test
    void aQueryIsAnsweredAtOnceAndRaw() {
        Bench bench = Bench.in(OiMode.PASSIVE);
        for (PacketGroup group : PacketGroup.values()) {
            assertThat(bench.send(new Sensors(group)).sent()).hasSize(group.size());
        }
        byte[] reply = bench.send(new QueryList(List.of(Packet.OI_MODE, Packet.VOLTAGE, Packet.OI_MODE)))
                .sent();
        assertThat(reply).hasSize(4).startsWith(1).endsWith(1);
        assertThat(bench.send(new QueryList(List.of())).sent()).isEmpty();
    }

    @Test
    void everyPacketStaysInItsDocumentedRange() {
        Bench bench = Bench.in(OiMode.PASSIVE).send(new Command.Clean()).stream(PacketGroup.GROUP_100);
        for (SensorValues frame : bench.seconds(30).frames()) {
            for (Packet packet : PacketGroup.GROUP_100.members()) {
                assertThat(frame.value(packet)).as("%s", packet).isBetween(packet.min(), packet.max());
            }
        }
    }

    @Test
    void theBatteryDrainsWhileTheRobotWorks() {
        Bench bench = Bench.in(OiMode.PASSIVE);
        assertThat(bench.query(Packet.BATTERY_CHARGE)).isEqualTo(bench.query(Packet.BATTERY_CAPACITY));
        int fullMilliVolts = bench.query(Packet.VOLTAGE);
        bench.send(new Command.Clean()).seconds(600);
        assertThat(bench.query(Packet.BATTERY_CHARGE)).isBetween(2_400, 2_600);
        assertThat(bench.query(Packet.VOLTAGE)).isLessThan(fullMilliVolts);
    }

    @Test
    void theCleaningMotorsDrawCurrentAsTheyArePowered() {
        Bench bench = Bench.in(OiMode.SAFE).send(new Motors(Motors.SIDE_BRUSH));
        assertThat(bench.query(Packet.SIDE_BRUSH_CURRENT)).isPositive();
        assertThat(bench.query(Packet.MAIN_BRUSH_CURRENT)).isZero();
        bench.send(new Motors(Motors.MAIN_BRUSH | Motors.MAIN_BRUSH_OUTWARD));
        int fullMilliAmps = bench.query(Packet.MAIN_BRUSH_CURRENT);
        assertThat(fullMilliAmps).isPositive();
        assertThat(bench.query(Packet.SIDE_BRUSH_CURRENT)).isZero();
        bench.send(new PwmMotors(-64, 0, 127));
        assertThat(bench.query(Packet.MAIN_BRUSH_CURRENT)).isBetween(1, fullMilliAmps - 1);
        assertThat(bench.query(Packet.CURRENT)).isLessThan(-300);
    }

    @Test
    void aSongPlaysForTheLengthOfItsNotes() {
        Song song = new Song(3, List.of(new Song.Note(60, 32), new Song.Note(62, 32)));
        Bench bench = Bench.in(OiMode.SAFE).send(new Play(3));
        assertThat(bench.query(Packet.SONG_PLAYING)).as("not stored yet").isZero();
        bench.send(song, new Play(3));
        assertThat(bench.query(Packet.SONG_PLAYING)).isEqualTo(1);
        assertThat(bench.query(Packet.SONG_NUMBER)).isEqualTo(3);
        bench.seconds(0.9);
        assertThat(bench.query(Packet.SONG_PLAYING)).isEqualTo(1);
        bench.seconds(0.2);
        assertThat(bench.query(Packet.SONG_PLAYING)).isZero();
    }

    @Test
    void aSongThatIsTooLongSpillsOverIntoTheNext() {
        Song.Note eighth = new Song.Note(60, 8);
        Bench bench = Bench.in(OiMode.SAFE).send(new Song(1, Collections.nCopies(20, eighth)));
        assertThat(playingSeconds(bench, 0)).isZero();
        assertThat(playingSeconds(bench, 1)).isCloseTo(20 * 8 / 64.0, within(0.02));
        assertThat(playingSeconds(bench, 2)).as("the rest").isCloseTo(4 * 8 / 64.0, within(0.02));
        assertThat(playingSeconds(bench, 3)).isZero();

        bench.send(new Song(2, List.of(new Song.Note(62, 64))));
        assertThat(playingSeconds(bench, 1)).as("with the other's note").isCloseTo((19 * 8 + 64) / 64.0, within(0.02));

        bench.send(new Song(4, Collections.nCopies(255, eighth)));
        assertThat(playingSeconds(bench, 4)).as("as far as memory reaches").isCloseTo(16 * 8 / 64.0, within(0.02));
    }

    private static double playingSeconds(Bench bench, int song) {
        bench.send(new Play(song));
        int ticks = 0;
        while (bench.query(Packet.SONG_PLAYING) == 1) {
            bench.ticks(1);
            ticks++;
        }
        return ticks * SimulatedRoomba.TICK_MILLIS / 1000.0;
    }

    @Test
    void theSameCallsGiveTheSameBytes() {
        assertThat(story().sent()).isEqualTo(story().sent());
    }

    @Test
    void noBytesAndPressesCanBreakIt() {
        qt().forAll(longs().all()).checkAssert(seed -> {
            Random random = new Random(seed);
            Bench bench = Bench.in(OiMode.FULL);
            byte[] noise = new byte[64];
            for (int round = 0; round < 50; round++) {
                random.nextBytes(noise);
                bench.robot.receive(noise, random.nextInt(noise.length));
                bench.robot.press(Button.values()[random.nextInt(8)], random.nextInt(400));
                bench.ticks(random.nextInt(20));
            }
            // Zeros complete any unfinished command.
            bench.robot.receive(new byte[1_000], 1_000);
            // Among them may have been a Reset.
            bench.seconds(5).send(Bench.START, new PauseResumeStream(false));
            assertThat(bench.query(Packet.OI_MODE)).isEqualTo(1);
        });
    }

    private static Bench story() {
        Bench bench = Bench.in(OiMode.PASSIVE).stream(PacketGroup.GROUP_100);
        bench.robot.press(Button.CLEAN);
        bench.seconds(1);
        bench.robot.press(Button.SPOT);
        return bench.seconds(60);
    }
}
