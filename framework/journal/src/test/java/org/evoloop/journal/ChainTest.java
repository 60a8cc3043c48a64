package org.evoloop.journal;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.catchThrowableOfType;
import static org.awaitility.Awaitility.await;

import java.io.IOException;
import java.io.RandomAccessFile;
import java.nio.ByteBuffer;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.nio.file.StandardOpenOption;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import org.evoloop.engine.Input;
import org.evoloop.engine.Snapshot;
import org.evoloop.time.ManualClock;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * A journal whose segments are not as they were written is never called sound: readers and the start say the same, and
 * who follows the remedy loses nothing.
 */
@Timeout(120)
class ChainTest {
    private static final List<Input> STORY = Story.of(Robot.RULES, new Random(5), 20_000);

    @TempDir
    private Path folder;

    private Path journal;
    private Path copy;
    private ManualClock clock;
    private Snapshot last;

    @BeforeEach
    void write() throws IOException {
        journal = folder.resolve("journal");
        copy = folder.resolve("copy");
        try (JournaledCore kept = begin(journal)) {
            kept.input(STORY);
            last = kept.core.snapshot();
            clock = kept.clock;
        }
        assertThat(Directory.segments(journal)).hasSizeGreaterThan(5);
        copyOf(journal, copy);
    }

    private static JournaledCore begin(Path journal) {
        return new JournaledCore(
                journal, Journal.in(journal).withSegmentBytes(1 << 16).withForcing(Forcing.NEVER));
    }

    private static void copyOf(Path from, Path to) throws IOException {
        Files.createDirectories(to);
        for (Path file : Directory.segments(from)) {
            Files.copy(file, to.resolve(file.getFileName()));
        }
    }

    private Path segment(int number) {
        return journal.resolve(Directory.name(number));
    }

    private int newest() {
        return Directory.segments(journal).size();
    }

    /** What a reader, a check of the options and a start say. */
    private String refused() {
        JournalException checked = catchThrowableOfType(
                JournalException.class, () -> Journal.in(journal).check(Robot.MODELS));
        JournalException read = catchThrowableOfType(JournalException.class, this::records);
        JournalException started = catchThrowableOfType(JournalException.class, this::started);
        assertThat(read).isNotNull();
        assertThat(read.isDamage()).isTrue();
        assertThat(started).isNotNull().hasMessage(read.getMessage());
        assertThat(checked).isNotNull().hasMessage(read.getMessage());
        return read.getMessage();
    }

    private List<JournalRecord> records() {
        List<JournalRecord> records = new ArrayList<>();
        new JournalFiles(journal).read(records::add);
        return records;
    }

    private Snapshot started() {
        return JournaledCore.recovered(Robot.RULES, journal, clock);
    }

    private void isSound() {
        Journal.in(journal).check(Robot.MODELS);
        assertThat(records()).isNotEmpty();
        assertThat(started()).isEqualTo(last);
    }

    /** The remedy for a segment that cannot be restored: nothing is deleted. */
    private void setAsideBefore(int number) throws IOException {
        Path aside = Files.createDirectory(journal.resolve("aside"));
        for (Path file : Directory.segments(journal)) {
            if (file.getFileName().toString().compareTo(Directory.name(number)) < 0) {
                Files.move(file, aside.resolve(file.getFileName()));
            }
        }
    }

    private void exchange(int one, int other) throws IOException {
        Path between = journal.resolve("between");
        Files.move(segment(one), between);
        Files.move(segment(other), segment(one));
        Files.move(between, segment(other));
    }

    @Test
    void untouchedItIsSound() {
        isSound();
    }

    @Test
    void segmentsThatWereSwapped() throws IOException {
        exchange(2, 4);

        assertThat(refused())
                .isEqualTo(segment(2) + ", byte 48: this is segment 4, under another name. The journal is damaged; give"
                        + " each file the name of its segment; another file has the name 0000000004.journal");

        exchange(2, 4);
        isSound();
    }

    @ParameterizedTest
    @CsvSource({"2, 3", "3, 2", "1, 5"})
    void aSegmentThatWasCopiedOverAnother(int from, int to) throws IOException {
        Files.delete(segment(to));
        Files.copy(segment(from), segment(to));

        assertThat(refused())
                .startsWith(segment(to) + ", byte 48: this is segment " + from + ", under another name.")
                .endsWith("it is there under its own name, too, so move this file out of the directory");

        Files.move(segment(to), folder.resolve("out"));
        assertThat(refused())
                .startsWith("the journal " + journal + " lacks " + Directory.name(to) + ", which "
                        + Directory.name(to + 1) + " continues.");
        setAsideBefore(to + 1);
        isSound();
    }

    @Test
    void aCopyAfterTheNewest() throws IOException {
        int next = newest() + 1;
        Files.copy(segment(newest()), segment(next));

        assertThat(refused()).startsWith(segment(next) + ", byte 48: this is segment " + (next - 1));

        Files.delete(segment(next));
        isSound();
    }

    @Test
    void aSegmentThatWasRenamed() throws IOException {
        Path other = journal.resolve("0000000099.journal");
        Files.move(segment(3), other);

        assertThat(refused())
                .isEqualTo(other + ", byte 48: this is segment 3, under another name. The journal is damaged; rename it"
                        + " to 0000000003.journal");

        Files.move(other, segment(3));
        isSound();
    }

    @ParameterizedTest
    @ValueSource(ints = {1, 3})
    void aSegmentThatWasCut(int number) throws IOException {
        long whole = Files.size(segment(number));
        for (long length : new long[] {0, 5, 50, 103, 104, 110, whole / 2, whole - 8, whole - 1}) {
            cut(segment(number), length);
            assertThat(refused())
                    .startsWith(segment(number).toString())
                    .contains(length == 0 ? "it is empty" : ", byte " + length + ": it is cut")
                    .endsWith("restore the file from a copy; if there is none, move all segments before "
                            + Directory.name(number + 1) + " into the directory " + journal.resolve("aside")
                            + " (create it): the converter goes on from " + Directory.name(number + 1)
                            + ", which begins with its complete state");
            Files.delete(segment(number));
            Files.copy(copy.resolve(Directory.name(number)), segment(number));
        }
        isSound();
        cut(segment(number), 300);
        setAsideBefore(number + 1);
        isSound();
    }

    @Test
    void theNewestIsCutOrEmptied() throws IOException {
        Path file = segment(newest());
        for (long length : new long[] {0, 104, Files.size(file) / 2, Files.size(file) - 8}) {
            cut(file, length);
            assertThat(refused())
                    .startsWith(file.toString())
                    .endsWith("restore " + file.getFileName() + " from a copy; if there is none, keep the directory"
                            + " under another name and start with an empty one");
            Files.delete(file);
            Files.copy(copy.resolve(file.getFileName()), file);
        }
        isSound();
    }

    @ParameterizedTest
    @ValueSource(ints = {0, 16, 104, 1000})
    void zerosWhereSomethingWas(int from) throws IOException {
        try (RandomAccessFile file = new RandomAccessFile(segment(newest()).toFile(), "rw")) {
            file.seek(from);
            file.write(new byte[(int) (file.length() - from)]);
        }
        refused();
    }

    @Test
    void somethingAppended() throws IOException {
        Files.write(segment(2), new byte[64], StandardOpenOption.APPEND);

        assertThat(refused()).contains("something follows its end");
    }

    private static void cut(Path file, long length) throws IOException {
        try (RandomAccessFile opened = new RandomAccessFile(file.toFile(), "rw")) {
            opened.setLength(length);
        }
    }

    @ParameterizedTest
    @ValueSource(ints = {1, 2, 4})
    void aSegmentThatWasRemoved(int number) throws IOException {
        Files.delete(segment(number));

        String next = Directory.name(number + 1);
        assertThat(refused())
                .startsWith("the journal " + journal + " lacks " + Directory.name(number) + ", which " + next
                        + " continues. The journal is damaged; restore the file from a copy; if there is none, move all"
                        + " segments before " + next);

        setAsideBefore(number + 1);
        isSound();
    }

    @Test
    void theNewestWasRemoved() throws IOException {
        int number = newest();
        Files.delete(segment(number));

        assertThat(refused())
                .isEqualTo("the journal " + journal + " lacks " + Directory.name(number) + ", which continued "
                        + Directory.name(number - 1) + ". The journal is damaged; restore " + Directory.name(number)
                        + " from a copy; if there is none, keep the directory under another name and start with an"
                        + " empty one");

        Files.copy(copy.resolve(Directory.name(number)), segment(number));
        isSound();
    }

    @Test
    void segmentsOfAnotherJournal() throws IOException {
        Path other = folder.resolve("other");
        try (JournaledCore kept = begin(other)) {
            kept.input(STORY);
        }
        Files.delete(segment(3));
        Files.copy(other.resolve(Directory.name(3)), segment(3));

        assertThat(refused())
                .startsWith("the journal " + journal + " holds segments of different journals: 0000000001.journal, ")
                .contains("; 0000000003.journal of journal ");
    }

    /** Two converters that went on from copies of one journal wrote different segments with the same numbers. */
    @Test
    void segmentsOfAnotherCourseOfTheSameJournal() throws IOException {
        int next = newest() + 1;
        for (Path each : List.of(journal, copy)) {
            try (JournaledCore kept = begin(each)) {
                kept.input(Story.of(Robot.RULES, new Random(each == copy ? 8 : 9), 6_000));
                last = kept.core.snapshot();
            }
        }
        Files.copy(copy.resolve(Directory.name(next)), segment(next), StandardCopyOption.REPLACE_EXISTING);

        assertThat(refused()).startsWith(segment(next + 1) + ", byte 64: it continues a segment that ended at byte ");
    }

    /** A record that was replaced, with a right checksum, does not fit into what follows. */
    @Test
    void aRecordThatWasForged() throws IOException {
        byte[] bytes = Files.readAllBytes(segment(2));
        SegmentReader reader = new SegmentReader(segment(2));
        reader.next();
        int header = reader.at() - Frame.HEADER_BYTES;
        bytes[reader.at()] ^= 1;
        ByteBuffer.wrap(bytes)
                .putLong(header, Frame.header(reader.length(), Frame.crcOf(bytes, reader.at(), reader.length())));
        Files.write(segment(2), bytes);

        assertThat(refused()).startsWith(segment(2) + ", byte 88: its records end at ");
    }

    @Test
    void theOldestAreMissingOnlyWhenTheJournalHasOutgrownItsSize() throws IOException {
        Path small = folder.resolve("small");
        journal = small;
        try (JournaledCore kept = new JournaledCore(
                small,
                Journal.in(small)
                        .withSegmentBytes(1 << 16)
                        .withKeptBytes(4 << 16)
                        .withForcing(Forcing.NEVER))) {
            kept.input(STORY);
            last = kept.core.snapshot();
            clock = kept.clock;
        }
        List<Path> kept = Directory.segments(small);
        assertThat(kept.get(0).getFileName()).isNotEqualTo(segment(1).getFileName());
        isSound();

        Files.delete(kept.get(0));
        assertThat(refused()).contains(" lacks " + kept.get(0).getFileName() + ", which ");
        Files.createDirectory(small.resolve("aside"));
        isSound();
    }

    @Test
    void whatARetentionLeftBehindIsNoGap() throws IOException {
        try (JournaledCore kept = new JournaledCore(
                journal, Journal.in(journal).withSegmentBytes(1 << 16).withKeptBytes(3 << 16))) {
            last = kept.core.snapshot();
        }
        assertThat(Directory.segments(journal)).doesNotContain(segment(2));
        Files.copy(copy.resolve(Directory.name(1)), segment(1));

        isSound();
        assertThat(segment(1)).doesNotExist();
    }

    /** What has been written to a removed file is in the state with which the next segment begins. */
    @ParameterizedTest
    @ValueSource(booleans = {true, false})
    void theSegmentIsRemovedOrReplacedWhileItIsWritten(boolean removed) throws Exception {
        Path written;
        try (JournaledCore kept = new JournaledCore(journal, Journal.in(journal).withSegmentBytes(1 << 16))) {
            written = kept.segment();
            Files.delete(written);
            if (!removed) {
                Files.createFile(written);
            }
            await().until(() -> {
                kept.input(new Input.Dismissed(99, 3));
                return !kept.failures.isEmpty();
            });
            kept.input(STORY.subList(0, 10));
            last = kept.core.snapshot();
            assertThat(kept.failures)
                    .singleElement()
                    .asString()
                    .contains(written + " was removed, replaced or cut while it was written");
        }
        assertThat(refused()).contains(removed ? " lacks " + written.getFileName() : written + ": it is empty");
        setAsideBefore((int) SegmentReader.preamble(newestFile()).place().number());
        isSound();
    }

    private Path newestFile() {
        List<Path> all = Directory.segments(journal);
        return all.get(all.size() - 1);
    }
}
