package org.evoloop.journal;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Random;
import org.evoloop.core.Input;
import org.evoloop.core.Rules;
import org.evoloop.core.Snapshot;
import org.evoloop.time.ManualClock;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * A truncated file continues from its last complete record; a changed one is refused, unless the change has no meaning.
 */
class DamageTest {
    private static final List<Input> STORY = Story.of(Robot.RULES, new Random(3), 40);

    @TempDir
    private Path directory;

    private Path journal;
    private Snapshot before;
    private Snapshot last;
    private ManualClock clock;

    @BeforeEach
    void write() throws Exception {
        journal = directory.resolve("journal");
        try (JournaledCore kept = JournaledCore.in(journal)) {
            kept.input(STORY.subList(0, STORY.size() - 1));
            before = kept.core.snapshot();
            kept.input(STORY.subList(STORY.size() - 1, STORY.size()));
            last = kept.core.snapshot();
            clock = kept.clock;
            // As a killed process leaves it.
            kept.copyTo(directory.resolve("killed"));
        }
    }

    private static Path segmentIn(Path journal) {
        return Directory.segments(journal).get(0);
    }

    private int endOfLastRecord() {
        return (int) segmentIn(journal).toFile().length();
    }

    private int startOfLastRecord() {
        SegmentReader reader = new SegmentReader(segmentIn(journal));
        int start = 0;
        while (reader.next()) {
            start = reader.at() - Frame.HEADER_BYTES;
        }
        return start;
    }

    private Snapshot recovered(byte[] bytes, Path file) throws Exception {
        Files.write(file, bytes);
        Replay replay = new Replay(Robot.RULES, Fingerprint.of(Robot.MODELS), new JournaledCore.Forgetting());
        replay.of(List.of(file));
        return replay.result(clock);
    }

    @ParameterizedTest
    @ValueSource(strings = {"journal", "killed"})
    void cutOffAtEveryByteOfTheLastRecord(String which) throws Exception {
        byte[] whole = Files.readAllBytes(segmentIn(directory.resolve(which)));
        Path file = directory.resolve("cut");
        for (int length = startOfLastRecord(); length < endOfLastRecord(); length++) {
            assertThat(later(recovered(Arrays.copyOf(whole, length), file)))
                    .as("cut at %d", length)
                    .isEqualTo(later(before));
            assertThat(file.toFile().length()).isEqualTo(startOfLastRecord());
        }
        assertThat(recovered(Arrays.copyOf(whole, endOfLastRecord()), file)).isEqualTo(last);
    }

    /** The last input may carry a later time, to which the clock was advanced. */
    private Snapshot later(Snapshot recovered) {
        return recovered.later(-recovered.nowNanos());
    }

    @ParameterizedTest
    @ValueSource(strings = {"journal", "killed"})
    void everyEleventhBitChanged(String which) throws Exception {
        changeBits(which, 11);
    }

    @ParameterizedTest
    @ValueSource(strings = {"journal", "killed"})
    @Tag("slow")
    void everyBitChanged(String which) throws Exception {
        changeBits(which, 1);
    }

    /** Of the unused space that a killed process leaves, a little is enough. */
    private void changeBits(String which, int step) throws Exception {
        byte[] left = Files.readAllBytes(segmentIn(directory.resolve(which)));
        byte[] whole = Arrays.copyOf(left, Math.min(left.length, endOfLastRecord() + 4096));
        Path file = directory.resolve("changed");
        for (int bit = 0; bit < 8 * endOfLastRecord(); bit += step) {
            byte[] changed = whole.clone();
            changed[bit / 8] ^= (byte) (1 << bit % 8);
            try {
                assertThat(recovered(changed, file)).as("bit %d", bit).isEqualTo(last);
            } catch (JournalException refused) {
                assertThat(refused).hasMessageStartingWith(file + ", byte ").hasMessageContaining("directory");
            }
        }
    }

    /** If record headers were not aligned, a kill could leave half of one. */
    @Test
    void everyRecordBeginsWhereItsHeaderIsWrittenInOnePiece() {
        SegmentReader reader = new SegmentReader(segmentIn(journal));
        int records = 0;
        while (reader.next()) {
            assertThat(reader.at() % 8).as("record %d", reader.number()).isZero();
            records++;
        }
        assertThat(records).isGreaterThan(STORY.size() / 2);
    }

    @Test
    void anotherVersionIsRefused() throws Exception {
        Path segment = segmentIn(journal);
        byte[] bytes = Files.readAllBytes(segment);
        ByteBuffer.wrap(bytes).putInt(8, Preamble.VERSION + 1);
        ByteBuffer.wrap(bytes).putInt(12, Frame.crcOf(bytes, 0, 12));
        Files.write(segment, bytes);

        assertThatThrownBy(() -> JournaledCore.recovered(Robot.RULES, journal, clock))
                .isInstanceOf(JournalException.class)
                .hasMessage(segment
                        + ", byte 8: it is written in version " + (Preamble.VERSION + 1)
                        + " of the format, and this Evoloop reads version "
                        + Preamble.VERSION + "; use "
                        + "the version of Evoloop that wrote it, or start with an empty directory");
    }

    @Test
    void aJournalOfOtherModelsIsRefused() {
        assertThatThrownBy(
                        () -> JournaledCore.recovered(Robot.rules(Robot.models("another", "Spot"), 8), journal, clock))
                .isInstanceOf(JournalException.class)
                .hasMessageStartingWith(segmentIn(journal) + ", byte 32, record 0: the journal is of other models:"
                        + " 'original' and 'new', fingerprint ")
                .hasMessageContaining("not 'another' and 'new'")
                .hasMessageEndingWith("start with the models that it was written with, or use another directory");
    }

    @Test
    void modelsMayMove() {
        Rules moved = Robot.rules(Robot.models("/elsewhere/original.scxml", "Clean"), 8);

        assertThat(JournaledCore.recovered(moved, journal, clock))
                .isEqualTo(JournaledCore.recovered(Robot.RULES, journal, clock));
    }

    @Test
    void aSegmentThatWasOnlyBeingCreatedIsLeftOut() throws Exception {
        Path blank = journal.resolve("0000000002.journal");
        Files.write(blank, new byte[500]);

        assertThat(JournaledCore.recovered(Robot.RULES, journal, clock)).isEqualTo(last);
        assertThat(blank).doesNotExist();
    }

    @Test
    void aSegmentThatIsMissingIsNoticed() throws Exception {
        Files.copy(segmentIn(journal), journal.resolve("0000000003.journal"));

        assertThatThrownBy(() -> JournaledCore.recovered(Robot.RULES, journal, clock))
                .hasMessage(
                        "the journal " + journal + " lacks the segment before 0000000003.journal; it is needed to go"
                                + " on. " + Directory.DAMAGED);
    }

    @Test
    void aPowerCutMayLeaveATornRecordWhereNothingWasSure() throws Exception {
        byte[] bytes = Files.readAllBytes(segmentIn(directory.resolve("killed")));
        bytes[endOfLastRecord() - 1] ^= 1;
        assertThatThrownBy(() -> recovered(bytes, directory.resolve("same")))
                .as("the computer has not been restarted")
                .hasMessageContaining("its checksum is wrong");

        byte[] other = inAnotherBoot(bytes);
        assertThat(later(recovered(other, directory.resolve("other")))).isEqualTo(later(before));
    }

    /** The head, with its checksum, as if it had been written before the computer was started. */
    private byte[] inAnotherBoot(byte[] bytes) {
        byte[] changed = bytes.clone();
        String boot = Boot.ID;
        int at = new String(bytes, StandardCharsets.ISO_8859_1).indexOf(boot);
        changed[at] = (byte) (changed[at] == 'x' ? 'y' : 'x');
        int payload = Preamble.BYTES + Frame.HEADER_BYTES;
        int length = Frame.length(ByteBuffer.wrap(bytes).getLong(Preamble.BYTES));
        ByteBuffer.wrap(changed).putLong(Preamble.BYTES, Frame.header(length, Frame.crcOf(changed, payload, length)));
        return changed;
    }
}
