package org.evoloop.roomba.simulator.robot;

import static org.assertj.core.api.Assertions.assertThat;

import org.evoloop.roomba.oi.Button;
import org.evoloop.roomba.oi.Command;
import org.evoloop.roomba.oi.OiMode;
import org.evoloop.roomba.oi.Packet;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Falling asleep, waking, and the second use of the wake line. */
class SleepTest {
    private static final int FAST = 115_200;
    private static final int SLOW = 19_200;

    private static Bench asleep(RobotOptions options) {
        Bench bench = Bench.in(OiMode.PASSIVE, options).stream(Packet.BUTTONS).seconds(301);
        assertThat(bench.state().asleep()).isTrue();
        bench.sent();
        return bench;
    }

    private static Bench asleep() {
        return asleep(RobotOptions.defaults());
    }

    @Test
    void fiveIdleMinutesInPassiveAndItSleeps() {
        Bench bench = Bench.in(OiMode.PASSIVE).seconds(299.9);
        assertThat(bench.state().asleep()).isFalse();
        bench.seconds(0.2);
        assertThat(bench.state().asleep()).isTrue();
        assertThat(bench.state().activity()).isEqualTo(RobotActivity.OFF);
        assertThat(bench.state().oiMode()).isEqualTo(OiMode.OFF);
    }

    @ParameterizedTest
    @EnumSource(
            value = OiMode.class,
            names = {"OFF", "SAFE", "FULL"})
    void inOtherModesItStaysAwake(OiMode mode) {
        assertThat(Bench.in(mode).seconds(900).state().asleep()).isFalse();
    }

    @Test
    void itStaysAwakeWhileItDoesSomethingOrCharges() {
        assertThat(Bench.in(OiMode.PASSIVE)
                        .send(new Command.Clean())
                        .seconds(900)
                        .state()
                        .asleep())
                .isFalse();
        Bench docked = Bench.in(OiMode.PASSIVE);
        docked.robot.dock();
        assertThat(docked.seconds(900).state().asleep()).isFalse();
    }

    @Test
    void aPressAPulseOrAWhileUnderControlBeginsTheTimeAnew() {
        Bench bench = Bench.in(OiMode.PASSIVE).seconds(200);
        bench.robot.press(Button.DOCK);
        bench.seconds(200).pulse(100).seconds(200);
        assertThat(bench.state().asleep()).isFalse();
        bench.send(Bench.SAFE).seconds(1).send(Bench.START).seconds(299);
        assertThat(bench.state().asleep()).isFalse();
        assertThat(bench.seconds(2).state().asleep()).isTrue();
    }

    @Test
    void asleepItIsSilentAndDeafExceptForTheWayOut() {
        Bench bench = asleep();
        byte[] query = {(byte) 128, (byte) 142, 35};
        bench.robot.receive(query, query.length);
        bench.robot.press(Button.SPOT);
        bench.robot.press(Button.DOCK);
        bench.seconds(10);
        assertThat(bench.sent()).isEmpty();
        assertThat(bench.state().asleep()).isTrue();
        assertThat(bench.state().pressed()).isEmpty();
    }

    @Test
    void theBytesOfItsSleepAreNotTakenForDataWhenItWakes() {
        Bench bench = Bench.in(OiMode.PASSIVE);
        byte[] unfinished = {(byte) 140, 0, 16};
        bench.robot.receive(unfinished, unfinished.length);
        bench.seconds(301).pulse(200).send(Bench.START);
        assertThat(bench.query(Packet.OI_MODE)).isEqualTo(1);
    }

    @Test
    void itsCleanButtonWakesItAndTurnsItOn() {
        Bench bench = asleep();
        bench.robot.press(Button.CLEAN);
        assertThat(bench.sentText()).isEqualTo("key-wakeup\r\nslept for 0 minutes 1 seconds\r\n");
        assertThat(bench.state().asleep()).isFalse();
        assertThat(bench.state().activity()).isEqualTo(RobotActivity.ON);
        assertThat(bench.ticks(10).sent()).as("the stream is forgotten").isEmpty();
        assertThat(bench.send(Bench.START).query(Packet.OI_MODE)).isEqualTo(1);
    }

    @ParameterizedTest
    @ValueSource(ints = {50, 100, 500, 1_000})
    void aPulseOfTheWakeLineWakesIt(int millis) {
        Bench bench = asleep().pulse(millis);
        assertThat(bench.state().asleep()).isFalse();
        assertThat(bench.state().activity()).isEqualTo(RobotActivity.OFF);
        assertThat(bench.send(Bench.START).query(Packet.OI_MODE)).isEqualTo(1);
    }

    @Test
    void aGlitchDoesNotWakeItNorDoesALineThatASleepyRobotLacks() {
        assertThat(asleep().pulse(15).state().asleep()).isTrue();
        Bench sleepy = asleep(RobotOptions.builder().sleepy(true).build()).pulse(500);
        sleepy.robot.wakeUp();
        assertThat(sleepy.state().asleep()).isTrue();
        sleepy.robot.press(Button.CLEAN);
        assertThat(sleepy.state().asleep()).isFalse();
    }

    @Test
    void theDockWakesIt() {
        Bench bench = asleep();
        bench.robot.dock();
        bench.ticks(1);
        assertThat(bench.sentText()).startsWith("charger-wakeup\r\n");
        assertThat(bench.state().asleep()).isFalse();
    }

    @ParameterizedTest
    @CsvSource({
        "2.5, 3, 100, 19200",
        "2.5, 3, 60, 19200",
        "2.5, 3, 495, 19200",
        "2.5, 2, 100, 115200",
        "2.5, 3, 30, 115200",
        "2.5, 3, 600, 115200",
        "0.5, 3, 100, 115200",
        "25, 3, 100, 115200"
    })
    void threeShortPulsesSoonAfterPowerOnMakeItSlow(double afterSeconds, int pulses, int millis, int baud) {
        Bench bench = new Bench().seconds(afterSeconds);
        for (int pulse = 0; pulse < pulses; pulse++) {
            bench.pulse(millis).seconds(0.1);
        }
        assertThat(bench.robot.baud()).isEqualTo(baud);
    }

    @Test
    void theRateLastsUntilResetOrCommandBaud() {
        Bench bench = Bench.in(OiMode.PASSIVE)
                .send(new Command.Baud(SLOW))
                .seconds(400)
                .pulse(500);
        assertThat(bench.robot.baud()).as("after sleep").isEqualTo(SLOW);
        bench.robot.clientBaud(SLOW);
        bench.send(Bench.START, new Command.Reset());
        assertThat(bench.robot.baud()).isEqualTo(FAST);
    }

    @Test
    void commandBaudIsIgnoredInOff() {
        assertThat(new Bench().send(new Command.Baud(SLOW)).robot.baud()).isEqualTo(FAST);
    }
}
