package org.evoloop.roomba.oi;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.quicktheories.QuickTheory.qt;

import java.time.DayOfWeek;
import java.time.LocalTime;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.stream.Stream;
import org.assertj.core.api.ThrowableAssert.ThrowingCallable;
import org.evoloop.roomba.oi.ActuatorCommand.Song.Note;
import org.evoloop.roomba.oi.CommandParser.Parsed;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.MethodSource;

class CommandTest {

    @ParameterizedTest
    @EnumSource
    void encodedThenParsedIsTheSameCommand(Opcode opcode) {
        qt().withExamples(300)
                .forAll(RandomCommands.of(opcode))
                .checkAssert(command ->
                        assertThat(Feeding.parse(command.bytes())).containsExactly(new Parsed.Accepted(command)));
    }

    @ParameterizedTest
    @EnumSource
    void startsWithTheOpcodeOfItsOwnType(Opcode opcode) {
        qt().withExamples(20).forAll(RandomCommands.of(opcode)).checkAssert(command -> {
            assertThat(command).isInstanceOf(opcode.type());
            assertThat(command.opcode()).isEqualTo(opcode);
            assertThat(command.bytes()[0] & 0xFF).isEqualTo(opcode.code());
        });
    }

    static Stream<Arguments> mistakes() {
        return Stream.of(
                mistake(
                        () -> new ActuatorCommand.Drive(501, 0),
                        "velocityMmPerS is 501 mm/s; allowed is -500 to 500 mm/s"),
                mistake(() -> new ActuatorCommand.Drive(0, 2001), "radiusMm is 2001 mm"),
                mistake(() -> new ActuatorCommand.DriveDirect(-501, 0), "rightMmPerS is -501 mm/s"),
                mistake(() -> new ActuatorCommand.DriveDirect(0, 501), "leftMmPerS is 501 mm/s"),
                mistake(() -> new ActuatorCommand.DrivePwm(256, 0), "rightPwm is 256"),
                mistake(() -> new ActuatorCommand.DrivePwm(0, -256), "leftPwm is -256"),
                mistake(() -> new ActuatorCommand.Motors(32), "bits is 32; allowed is 0 to 31"),
                mistake(() -> new ActuatorCommand.PwmMotors(-128, 0, 0), "mainBrushPwm is -128"),
                mistake(() -> new ActuatorCommand.PwmMotors(0, 128, 0), "sideBrushPwm is 128"),
                mistake(() -> new ActuatorCommand.PwmMotors(0, 0, -1), "vacuumPwm is -1"),
                mistake(() -> new ActuatorCommand.Leds(16, 0, 0), "bits is 16"),
                mistake(() -> new ActuatorCommand.Leds(0, 256, 0), "powerColor is 256"),
                mistake(() -> new ActuatorCommand.Leds(0, 0, -1), "powerIntensity is -1"),
                mistake(() -> new ActuatorCommand.SchedulingLeds(128, 0), "weekdayBits is 128"),
                mistake(() -> new ActuatorCommand.SchedulingLeds(0, 32), "scheduleBits is 32"),
                mistake(() -> new ActuatorCommand.DigitLedsRaw(0, 0, 128, 0), "digit1 is 128"),
                mistake(() -> new ActuatorCommand.DigitLedsAscii("ABC"), "length of text is 3 characters"),
                mistake(() -> new ActuatorCommand.DigitLedsAscii("AB\nD"), "character of text is 10"),
                mistake(() -> new ActuatorCommand.Play(5), "song number is 5; allowed is 0 to 4"),
                mistake(() -> new ActuatorCommand.Song(0, List.of()), "number of notes is 0; allowed is 1 to 255"),
                mistake(() -> new ActuatorCommand.Song(-1, List.of(new Note(60, 1))), "song number is -1"),
                mistake(() -> new Note(256, 0), "pitch is 256"),
                mistake(() -> new Note(60, 256), "durationIn64thsOfSecond is 256"),
                mistake(() -> new Command.Baud(9601), "bitsPerSecond is 9601 bit/s; allowed is one of [300, 600"),
                mistake(
                        () -> new Command.SetDayTime(DayOfWeek.MONDAY, LocalTime.of(1, 2, 3)),
                        "time is 01:02:03; allowed are whole minutes"),
                mistake(
                        () -> new InputCommand.QueryList(Collections.nCopies(256, Packet.WALL)),
                        "number of packets is 256; allowed is 0 to 255"),
                mistake(
                        () -> new InputCommand.Stream(Collections.nCopies(4, PacketGroup.GROUP_100)),
                        "ids and data in a stream frame is 324 bytes; allowed is 0 to 255 bytes"));
    }

    private static Arguments mistake(ThrowingCallable mistake, String message) {
        return Arguments.of(message, mistake);
    }

    @ParameterizedTest(name = "{0}")
    @MethodSource("mistakes")
    void shouldNameFieldValueAndRangeWhenOutOfRange(String message, ThrowingCallable mistake) {
        assertThatIllegalArgumentException().isThrownBy(mistake).withMessageContaining(message);
    }

    @Test
    void driveTakesBothFormsOfStraight() {
        assertThat(new ActuatorCommand.Drive(100, ActuatorCommand.Drive.STRAIGHT).bytes())
                .containsExactly(137, 0, 100, 0x7F, 0xFF);
        assertThat(new ActuatorCommand.Drive(100, -32768).bytes()).containsExactly(137, 0, 100, 0x80, 0x00);
    }

    @Test
    void spinsHaveTheSpecialRadii() {
        assertThat(new ActuatorCommand.Drive(100, ActuatorCommand.Drive.SPIN_CLOCKWISE).bytes())
                .containsExactly(137, 0, 100, 0xFF, 0xFF);
        assertThat(new ActuatorCommand.Drive(100, ActuatorCommand.Drive.SPIN_COUNTERCLOCKWISE).bytes())
                .containsExactly(137, 0, 100, 0x00, 0x01);
    }

    @Test
    void rightWheelComesFirst() {
        assertThat(new ActuatorCommand.DriveDirect(1, -2).bytes()).containsExactly(145, 0, 1, 0xFF, 0xFE);
        assertThat(new ActuatorCommand.DrivePwm(3, -4).bytes()).containsExactly(146, 0, 3, 0xFF, 0xFC);
    }

    @Test
    void emptyStreamAndEmptyScheduleSwitchOff() {
        assertThat(new InputCommand.Stream(List.of()).bytes()).containsExactly(148, 0);
        assertThat(new Command.Schedule(Map.of()).bytes())
                .hasSize(16)
                .startsWith(167, 0)
                .endsWith(0, 0);
    }
}
