package org.evoloop.journal;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.RandomAccessFile;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import java.util.Set;
import java.util.TreeSet;
import java.util.function.LongSupplier;
import java.util.function.Supplier;
import org.evoloop.converter.ConverterJournal.Past;
import org.evoloop.engine.Core;
import org.evoloop.engine.Input;
import org.evoloop.engine.Output;
import org.evoloop.engine.codec.ByteItems;
import org.evoloop.engine.codec.ByteWriter;
import org.evoloop.evolution.ModelPair;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.State;
import org.evoloop.statemachine.StateMachine;
import org.evoloop.statemachine.Transition;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Reading a journal from outside the converter that writes it. */
class JournalFilesTest {
    @TempDir
    private Path directory;

    private static String at(Core core) {
        return core.at() + " " + core.doubt();
    }

    private List<String> read(List<JournalRecord> records) {
        new JournalFiles(directory).read(records::add);
        return records.stream().map(each -> each.where() + " " + each.doubt()).toList();
    }

    @Test
    void eachRecordShowsWhereTheCoreWasWhileTheJournalIsInUse() {
        try (JournaledCore kept = JournaledCore.in(directory)) {
            for (Input input : Story.of(Robot.RULES, new Random(1), 80)) {
                kept.input(input);
                List<String> where = read(new ArrayList<>());
                assertThat(where.isEmpty() ? at(kept.core) : where.get(where.size() - 1))
                        .as("after %s", input)
                        .isEqualTo(at(kept.core));
            }
        }
    }

    @Test
    void manySegmentsAreOneStory() {
        Journal small = Journal.in(directory).withSegmentBytes(1 << 16);
        try (JournaledCore kept = new JournaledCore(directory, small)) {
            kept.input(Story.of(Robot.RULES, new Random(2), 20_000));
            List<JournalRecord> records = new ArrayList<>();
            List<String> where = read(records);
            assertThat(where.get(where.size() - 1)).isEqualTo(at(kept.core));
            assertThat(records).extracting(JournalRecord::segment).contains("0000000001.journal", "0000000005.journal");
            assertThat(records).isSortedAccordingTo((one, other) -> Long.compare(one.nanos(), other.nanos()));
        }
    }

    /** The oldest ones are, when the journal outgrows its size. */
    @Test
    void segmentsThatAreDeletedWhileTheyAreReadAreLeftOut() {
        Journal small = Journal.in(directory)
                .withSegmentBytes(1 << 16)
                .withKeptBytes(5 << 16)
                .withForcing(Forcing.NEVER);
        try (JournaledCore kept = new JournaledCore(directory, small)) {
            List<Input> story = Story.of(Robot.RULES, new Random(4), 20_000);
            kept.input(story);
            List<Path> before = Directory.segments(directory);
            Set<String> read = new TreeSet<>();
            new JournalFiles(directory).read(record -> {
                if (read.add(record.segment()) && read.size() == 1) {
                    grow(kept, before.get(before.size() - 2));
                }
            });
            assertThat(read)
                    .contains(before.get(0).getFileName().toString())
                    .doesNotContain(before.get(1).getFileName().toString());

            List<Path> present = Directory.segments(directory);
            List<Instant> replayed = new ArrayList<>();
            kept.journal.replay(Robot.RULES, new Past() {
                @Override
                public void at(Supplier<Instant> time, LongSupplier nanos) {
                    if (replayed.isEmpty()) {
                        grow(kept, present.get(1));
                    }
                    replayed.add(time.get());
                }

                @Override
                public void say(Output output) {}
            });
            assertThat(replayed).hasSizeLessThan(present.size());
        }
    }

    private static void grow(JournaledCore kept, Path until) {
        while (Files.exists(until)) {
            kept.input(new Input.Dismissed(99, 3));
        }
    }

    @Test
    void aFileThatIsNoSegmentIsReportedWithItsName() throws Exception {
        Path segment = directory.resolve("0000000001.journal");
        Files.createDirectory(segment);
        assertThatThrownBy(() -> read(new ArrayList<>()))
                .isInstanceOf(JournalException.class)
                .hasMessage(segment + " cannot be read: it is not a regular file; restore a copy of the directory, or "
                        + "use another");
        Files.delete(segment);
        Files.createSymbolicLink(segment, directory.resolve("nowhere"));
        assertThatThrownBy(() -> read(new ArrayList<>()))
                .isInstanceOf(JournalException.class)
                .hasMessageStartingWith(segment + " cannot be read: it is missing; ");
        Files.delete(segment);
        try (RandomAccessFile huge = new RandomAccessFile(segment.toFile(), "rw")) {
            huge.setLength(3L << 30);
        }
        assertThatThrownBy(() -> read(new ArrayList<>()))
                .isInstanceOf(JournalException.class)
                .hasMessageStartingWith(segment + " cannot be read: its 3221225472 bytes do not fit");
    }

    @Test
    void damageIsDistinguishedFromFilesThatAreNotJournals() throws Exception {
        assertThatThrownBy(() -> new JournalFiles(directory))
                .hasMessageContaining("is not a journal")
                .isInstanceOfSatisfying(
                        JournalException.class,
                        wrong -> assertThat(wrong.isDamage()).isFalse());
        try (JournaledCore kept = JournaledCore.in(directory)) {
            kept.input(Story.of(Robot.RULES, new Random(3), 20));
        }
        Path segment = Directory.segments(directory).get(0);
        byte[] bytes = Files.readAllBytes(segment);
        bytes[bytes.length - 1] ^= 1;
        Files.write(segment, bytes);
        assertThatThrownBy(() -> read(new ArrayList<>()))
                .hasMessageContaining("its checksum is wrong")
                .isInstanceOfSatisfying(
                        JournalException.class,
                        wrong -> assertThat(wrong.isDamage()).isTrue());
    }

    @Test
    void theModelsComeBackAsTheyWere() {
        StateMachine machine = StateMachine.named("one of everything")
                .drawn(new State("Off [history Dim]"), new State("Off"), List.of("hum"), List.of("Lamp.Off"), false)
                .drawn(new State("End"), new State("End"), List.of(), List.of("Lamp.A", "Lamp.B"), true)
                .initial("Off [history Dim]")
                .initialEffects(List.of("begin"))
                .spontaneous("burnOut")
                .defers("End", new Event("switch"))
                .deviceState("End", "Lamp.Off")
                .sends("End", "switch")
                .inheritedDeviceState("Off [history Dim]", "Off")
                .transition(
                        new Transition(
                                new State("Off [history Dim]"),
                                new Event("switch", List.of("dark")),
                                new State("End"),
                                List.of("light"),
                                false,
                                Set.of("after 2 s")),
                        "")
                .transition(new Transition(new State("End"), new Event("tick"), new State("End"), List.of(), true), "")
                .build();
        ByteWriter bytes = ByteWriter.withTable();
        bytes.clear();
        MachineBytes.write(bytes, machine);
        ByteItems cursor = ByteItems.withTable(bytes.array());
        cursor.goTo(0, bytes.length());
        StateMachine back = MachineBytes.read(cursor);
        cursor.endsAll();

        assertThat(Fingerprint.of(new ModelPair(back, back)))
                .isEqualTo(Fingerprint.of(new ModelPair(machine, machine)));
        for (State state : machine.states()) {
            assertThat(back.withoutMemory(state)).isEqualTo(machine.withoutMemory(state));
            assertThat(back.activities(state)).isEqualTo(machine.activities(state));
            assertThat(back.paths(state)).isEqualTo(machine.paths(state));
            assertThat(back.isEnd(state)).isEqualTo(machine.isEnd(state));
            assertThat(back.deviceState(state)).isEqualTo(machine.deviceState(state));
            assertThat(back.inheritsDeviceState(state)).isEqualTo(machine.inheritsDeviceState(state));
            assertThat(back.sends(state)).isEqualTo(machine.sends(state));
        }
        assertThat(back.initialEffects()).isEqualTo(machine.initialEffects());
    }
}
