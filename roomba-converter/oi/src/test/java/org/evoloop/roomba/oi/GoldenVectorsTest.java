package org.evoloop.roomba.oi;

import static org.assertj.core.api.Assertions.assertThat;
import static org.evoloop.roomba.oi.Feeding.octets;

import java.time.DayOfWeek;
import java.time.LocalTime;
import java.util.List;
import java.util.Map;
import java.util.stream.Stream;
import org.evoloop.roomba.oi.StreamFrame.Checksum;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;

/** The specification's examples, byte for byte. */
class GoldenVectorsTest {

    static Stream<Arguments> examples() {
        return Stream.of(
                Arguments.of(new ActuatorCommand.Drive(-200, 500), octets(137, 255, 56, 1, 244)),
                Arguments.of(
                        new ActuatorCommand.Motors(ActuatorCommand.Motors.SIDE_BRUSH
                                | ActuatorCommand.Motors.MAIN_BRUSH
                                | ActuatorCommand.Motors.SIDE_BRUSH_CLOCKWISE),
                        octets(138, 13)),
                Arguments.of(new ActuatorCommand.Leds(ActuatorCommand.Leds.DOCK, 0, 128), octets(139, 4, 0, 128)),
                Arguments.of(new ActuatorCommand.DigitLedsAscii("ABCD"), octets(164, 65, 66, 67, 68)),
                Arguments.of(
                        new Command.Schedule(Map.of(
                                DayOfWeek.WEDNESDAY, LocalTime.of(15, 0), DayOfWeek.FRIDAY, LocalTime.of(10, 36))),
                        octets(167, 40, 0, 0, 0, 0, 0, 0, 15, 0, 0, 0, 10, 36, 0, 0)),
                Arguments.of(
                        new InputCommand.QueryList(List.of(Packet.BUMPS_AND_WHEEL_DROPS, Packet.VIRTUAL_WALL)),
                        octets(149, 2, 7, 13)),
                Arguments.of(
                        new InputCommand.Stream(List.of(Packet.CLIFF_FRONT_LEFT_SIGNAL, Packet.VIRTUAL_WALL)),
                        octets(148, 2, 29, 13)),
                Arguments.of(new Command.Baud(115200), octets(129, 11)));
    }

    @ParameterizedTest
    @MethodSource("examples")
    void commandHasTheBytesOfTheSpecification(Command command, byte[] expected) {
        assertThat(command.bytes()).containsExactly(expected);
        assertThat(Feeding.parse(expected)).containsExactly(new CommandParser.Parsed.Accepted(command));
    }

    @Test
    void streamFrameOfTheSpecificationCarriesTheChecksumThatCountsTheHeader() {
        List<Packet> packets = List.of(Packet.CLIFF_FRONT_LEFT_SIGNAL, Packet.VIRTUAL_WALL);
        SensorValues values = SensorValues.decode(packets, octets(2, 25, 0));
        assertThat(values.value(Packet.CLIFF_FRONT_LEFT_SIGNAL)).isEqualTo(537);
        assertThat(StreamFrame.encode(packets, values::value)).containsExactly(octets(19, 5, 29, 2, 25, 13, 0, 163));
        assertThat(StreamFrame.encode(packets, values::value, Checksum.WITHOUT_HEADER))
                .containsExactly(octets(19, 5, 29, 2, 25, 13, 0, 182));
    }
}
