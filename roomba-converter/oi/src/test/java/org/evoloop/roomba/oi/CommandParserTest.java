package org.evoloop.roomba.oi;

import static org.assertj.core.api.Assertions.assertThat;
import static org.evoloop.roomba.oi.Feeding.join;
import static org.evoloop.roomba.oi.Feeding.octets;
import static org.quicktheories.QuickTheory.qt;
import static org.quicktheories.generators.SourceDSL.lists;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.Random;
import org.evoloop.roomba.oi.CommandParser.Parsed;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class CommandParserTest {
    private static final Parsed START = new Parsed.Accepted(new Command.Start());

    @Test
    void everySplitOfASequenceGivesTheSameCommands() {
        List<Command> commands = List.of(
                new Command.Start(),
                new ActuatorCommand.Song(1, List.of(new ActuatorCommand.Song.Note(60, 32))),
                new Command.Schedule(Map.of()),
                new InputCommand.Stream(List.of(Packet.BUTTONS, PacketGroup.GROUP_100)),
                new ActuatorCommand.Drive(-200, 500),
                new Command.Stop());
        byte[] bytes = join(commands.stream().map(Command::bytes).toArray(byte[][]::new));
        for (int first = 0; first <= bytes.length; first++) {
            for (int second = first; second <= bytes.length; second++) {
                List<Parsed> parsed = new ArrayList<>();
                CommandParser parser = new CommandParser(parsed::add);
                parser.feed(bytes, 0, first);
                parser.feed(bytes, first, second - first);
                parser.feed(bytes, second, bytes.length - second);
                assertThat(parsed)
                        .as("split at %d and %d", first, second)
                        .extracting(one -> ((Parsed.Accepted) one).command())
                        .isEqualTo(commands);
            }
        }
    }

    @Test
    void anySequenceOfCommandsComesOutAsItWentIn() {
        qt().withExamples(500)
                .forAll(lists().of(RandomCommands.any()).ofSizeBetween(0, 12))
                .checkAssert(commands -> assertThat(Feeding.parse(
                                join(commands.stream().map(Command::bytes).toArray(byte[][]::new))))
                        .isEqualTo(commands.stream().map(Parsed.Accepted::new).toList()));
    }

    @Test
    void unfinishedCommandSwallowsTheNextOne() {
        // As the specification says, the robot waits for the data bytes, whatever they are.
        assertThat(Feeding.parse(octets(137, 0, 128, 0))).isEmpty();
        assertThat(Feeding.parse(octets(137, 0, 128, 0, 1, 128)))
                .containsExactly(new Parsed.Accepted(new ActuatorCommand.Drive(128, 1)), START);
    }

    @ParameterizedTest
    @ValueSource(ints = {0, 6, 8, 127, 151, 161, 166, 172, 174, 255})
    void unknownOpcodeIsSkippedAndReported(int code) {
        assertThat(Feeding.parse(octets(code, 128))).containsExactly(new Parsed.UnknownOpcode(code), START);
    }

    @Test
    void dataOfTheRemovedDigitalOutputsIsNotTakenForAReset() {
        assertThat(Feeding.parse(octets(147, 7, 128))).containsExactly(new Parsed.UnknownOpcode(147), START);
    }

    @Test
    void malformedCommandIsConsumedAndSaysWhy() {
        assertThat(Feeding.parse(octets(145, 0, 0, 2, 0, 128)))
                .containsExactly(
                        new Parsed.Malformed(
                                Opcode.DRIVE_DIRECT,
                                "leftMmPerS is 512 mm/s; allowed is -500 to 500 mm/s",
                                new ActuatorCommand.DriveDirect(0, 500)),
                        START);
        assertThat(Feeding.parse(octets(142, 59, 128)))
                .containsExactly(
                        new Parsed.Malformed(
                                Opcode.SENSORS, "packet id is 59; allowed is 0 to 58, 100, 101, 106 and 107", null),
                        START);
    }

    @Test
    void aWheelCommandOutOfItsRangeNamesTheNearestValidOne() {
        assertNearest(octets(137, 2, 88, 0, 100), new ActuatorCommand.Drive(500, 100));
        assertNearest(octets(137, 128, 0, 128, 0), new ActuatorCommand.Drive(-500, Short.MIN_VALUE));
        assertNearest(octets(137, 0, 100, 19, 136), new ActuatorCommand.Drive(100, 2000));
        assertNearest(octets(145, 253, 168, 0, 7), new ActuatorCommand.DriveDirect(-500, 7));
        assertNearest(octets(146, 1, 0, 254, 0), new ActuatorCommand.DrivePwm(255, -255));
    }

    private static void assertNearest(byte[] bytes, Command nearest) {
        assertThat(Feeding.parse(bytes))
                .singleElement()
                .isInstanceOfSatisfying(
                        Parsed.Malformed.class,
                        malformed -> assertThat(malformed.nearest()).isEqualTo(nearest));
    }

    @ParameterizedTest
    @ValueSource(ints = {12, 255})
    void baudCodeWithoutARateIsMalformed(int code) {
        assertMalformed(Opcode.BAUD, octets(129, code));
    }

    @Test
    void everyKindOfWrongDataIsConsumed() {
        assertMalformed(Opcode.PAUSE_RESUME_STREAM, octets(150, 2));
        assertMalformed(Opcode.PWM_MOTORS, octets(144, 128, 0, 0));
        assertMalformed(Opcode.DIGIT_LEDS_ASCII, octets(164, 65, 66, 200, 67));
        assertMalformed(Opcode.SET_DAY_TIME, octets(168, 7, 0, 0));
        assertMalformed(Opcode.SET_DAY_TIME, octets(168, 6, 24, 0));
        assertMalformed(Opcode.SCHEDULE, octets(167, 128, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0));
        assertMalformed(Opcode.SCHEDULE, octets(167, 64, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 60));
        assertMalformed(Opcode.STREAM, octets(148, 4, 100, 100, 100, 100));
        assertMalformed(Opcode.QUERY_LIST, octets(149, 2, 7, 200));
    }

    @Test
    void songWithoutNotesIsConsumed() {
        assertMalformed(Opcode.SONG, octets(140, 0, 0));
    }

    @ParameterizedTest
    @ValueSource(ints = {17, 128, 255})
    void songOfMoreNotesThanTheSpecificationAllowsIsTaken(int notes) {
        ActuatorCommand.Song.Note silence = new ActuatorCommand.Song.Note(0, 0);
        assertThat(Feeding.parse(join(octets(140, 0, notes), new byte[2 * notes])))
                .containsExactly(new Parsed.Accepted(new ActuatorCommand.Song(0, Collections.nCopies(notes, silence))));
    }

    @Test
    void emptyListsEndWithTheirCount() {
        assertThat(Feeding.parse(octets(148, 0, 149, 0, 128)))
                .containsExactly(
                        new Parsed.Accepted(new InputCommand.Stream(List.of())),
                        new Parsed.Accepted(new InputCommand.QueryList(List.of())),
                        START);
    }

    @Test
    void timeOfADayThatIsNotScheduledDoesNotMatter() {
        assertThat(Feeding.parse(octets(167, 0, 99, 99, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0)))
                .containsExactly(new Parsed.Accepted(new Command.Schedule(Map.of())));
    }

    @Test
    void aMillionRandomBytesNeitherThrowNorStall() {
        long seed = 20_160_810;
        List<Parsed> parsed = new ArrayList<>();
        CommandParser parser = new CommandParser(parsed::add);
        byte[] noise = Feeding.noise(new Random(seed), 1_000_000);
        parser.feed(noise, 0, noise.length);
        assertThat(parsed).as("seed %d", seed).hasAtLeastOneElementOfType(Parsed.Malformed.class);
        assertThat(parsed).as("seed %d", seed).hasAtLeastOneElementOfType(Parsed.Accepted.class);
        // The longest command that can be unfinished is a song of 255 notes; 0 is no opcode.
        byte[] padding = new byte[512];
        parser.feed(padding, 0, padding.length);
        parser.feed((byte) 128);
        assertThat(parsed.get(parsed.size() - 1)).as("seed %d", seed).isEqualTo(START);
    }

    private static void assertMalformed(Opcode opcode, byte[] bytes) {
        List<Parsed> parsed = Feeding.parse(join(bytes, octets(128)));
        assertThat(parsed).hasSize(2).last().isEqualTo(START);
        assertThat(parsed.get(0)).isInstanceOfSatisfying(Parsed.Malformed.class, malformed -> {
            assertThat(malformed.opcode()).isEqualTo(opcode);
            assertThat(malformed.reason()).contains("allowed");
        });
    }
}
