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
import org.evoloop.engine.Input;
import org.evoloop.engine.Rules;
import org.evoloop.engine.Snapshot;
import org.evoloop.time.ManualClock;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * A killed process's file continues from its last complete record; a changed or cut one is refused, unless the change
 * has no meaning.
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
        try (JournaledCore kept = new JournaledCore(
                journal, Journal.in(journal).withSegmentBytes(1 << 16).withForcing(Forcing.NEVER))) {
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

    /** The header is written last: without it, nothing of the record counts. */
    @Test
    void aRecordThatAKilledProcessWasWritingIsCutOff() throws Exception {
        byte[] whole = Files.readAllBytes(segmentIn(directory.resolve("killed")));
        Path file = directory.resolve("cut");
        int start = startOfLastRecord();
        for (int written = start; written <= endOfLastRecord(); written++) {
            byte[] torn = whole.clone();
            Arrays.fill(torn, start, start + Frame.HEADER_BYTES, (byte) 0);
            Arrays.fill(torn, Math.max(written, start), endOfLastRecord(), (byte) 0);
            assertThat(later(recovered(torn, file)))
                    .as("written to %d", written)
                    .isEqualTo(later(before));
            assertThat(file.toFile().length()).isEqualTo(start);
            assertThat(later(recovered(Files.readAllBytes(file), file))).isEqualTo(later(before));
        }
        assertThat(recovered(whole, file)).isEqualTo(last);
    }

    @ParameterizedTest
    @ValueSource(strings = {"journal", "killed"})
    void aFileThatIsCutIsRefused(String which) throws Exception {
        byte[] whole = Files.readAllBytes(segmentIn(directory.resolve(which)));
        Path file = directory.resolve("cut");
        for (int length = 0; length < whole.length; length += length < endOfLastRecord() + 16 ? 1 : 4001) {
            byte[] cut = Arrays.copyOf(whole, length);
            assertThatThrownBy(() -> recovered(cut, file))
                    .as("cut at %d", length)
                    .isInstanceOf(JournalException.class)
                    .hasMessageStartingWith(
                            file + (length == 0 ? ": it is empty" : ", byte " + length + ": it is cut"));
        }
    }

    /** Of what was not forced, a power cut leaves any part. */
    @Test
    void aPowerCutMayCutOffWhatWasNotSure() throws Exception {
        byte[] bytes = inAnotherBoot(Files.readAllBytes(segmentIn(directory.resolve("killed"))));
        for (int length = startOfLastRecord(); length < endOfLastRecord(); length++) {
            assertThat(later(recovered(Arrays.copyOf(bytes, length), directory.resolve("short"))))
                    .isEqualTo(later(before));
        }
        Preamble.sure(ByteBuffer.wrap(bytes), endOfLastRecord());
        byte[] sure = Arrays.copyOf(bytes, endOfLastRecord() - 8);
        assertThatThrownBy(() -> recovered(sure, directory.resolve("sure")))
                .hasMessageContaining("it is cut there; it was written up to byte " + endOfLastRecord());
        byte[] blank = bytes.clone();
        Arrays.fill(blank, startOfLastRecord(), endOfLastRecord(), (byte) 0);
        assertThatThrownBy(() -> recovered(blank, directory.resolve("blank")))
                .hasMessageContaining("its header is blank, though more was written");
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

    private void changeBits(String which, int step) throws Exception {
        byte[] whole = Files.readAllBytes(segmentIn(directory.resolve(which)));
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

    @ParameterizedTest
    @ValueSource(ints = {Preamble.VERSION - 1, Preamble.VERSION + 1})
    void anotherVersionIsRefused(int version) throws Exception {
        Path segment = segmentIn(journal);
        byte[] bytes = Files.readAllBytes(segment);
        ByteBuffer.wrap(bytes).putInt(8, version);
        ByteBuffer.wrap(bytes).putInt(12, Frame.crcOf(bytes, 0, 12));
        Files.write(segment, bytes);

        assertThatThrownBy(() -> JournaledCore.recovered(Robot.RULES, journal, clock))
                .isInstanceOf(JournalException.class)
                .hasMessage(segment
                        + ", byte 8: it is written in version " + version
                        + " of the format, and this Evoloop reads version "
                        + Preamble.VERSION + "; use "
                        + "the version of Evoloop that wrote it, or start with an empty directory");
    }

    @Test
    void magicHeaderAndLengthAreNamed() throws Exception {
        byte[] whole = Files.readAllBytes(segmentIn(journal));
        int header = startOfLastRecord();
        assertRefused(whole, 0, 'X', ", byte 0: it does not begin with EVOLOOPJ");
        assertRefused(whole, 11, 1, ", byte 8: the version does not match its checksum");
        assertRefused(whole, 50, 1, ", byte 32: its number and what came before do not match their checksum");
        assertRefused(whole, 90, 1, ", byte 88: its records end at byte ");
        assertRefused(whole, 96, 1, ", byte 96: the mark of its end is unknown");
        assertRefused(whole, Preamble.BYTES + 20, 1, ", byte 104, record 1: its checksum is wrong");
        assertRefused(whole, header + 2, 1, ", byte " + header + ", record ", ": the check of its length is wrong");

        byte[] longer = whole.clone();
        ByteBuffer.wrap(longer).putLong(header, Frame.header(1_000_000, 0));
        assertThatThrownBy(() -> recovered(longer, directory.resolve("changed")))
                .hasMessageContaining("its length of 1000000 bytes goes beyond the end of the file");
    }

    private void assertRefused(byte[] whole, int at, int change, String... words) {
        byte[] changed = whole.clone();
        changed[at] ^= (byte) change;
        Path file = directory.resolve("changed");
        assertThatThrownBy(() -> recovered(changed, file))
                .hasMessageStartingWith(file + words[0])
                .hasMessageContainingAll(words);
    }

    @Test
    void aJournalOfOtherModelsIsRefused() {
        assertThatThrownBy(
                        () -> JournaledCore.recovered(Robot.rules(Robot.models("another", "Spot"), 8), journal, clock))
                .isInstanceOf(JournalException.class)
                .hasMessageStartingWith(segmentIn(journal) + ", byte 104, record 0: the journal is of other models:"
                        + " 'original' and 'new', fingerprint ")
                .hasMessageContaining("not 'another' and 'new'")
                .hasMessageEndingWith("start with the models that it was written with, or use another directory");
    }

    @Test
    void aModelThatHasChangedUnderItsNameIsSaidToHaveChanged() {
        assertThatThrownBy(
                        () -> JournaledCore.recovered(Robot.rules(Robot.models("original", "Spot"), 8), journal, clock))
                .hasMessageContaining("not 'original' and 'new'")
                .hasMessageContaining("a model has changed since");
    }

    /** What a start would refuse is found without it, and nothing is changed. */
    @Test
    void whatAStartWouldRefuseIsFoundBefore() throws Exception {
        Journal kept = Journal.in(journal);
        kept.check(Robot.MODELS);
        assertThatThrownBy(() -> kept.check(Robot.models("another", "Spot")))
                .hasMessageStartingWith(segmentIn(journal) + ", byte 104, record 0: the journal is of other models:");
        Journal.in(directory.resolve("not/yet/there")).check(Robot.MODELS);
        assertThat(directory.resolve("not")).doesNotExist();
        Path file = Files.writeString(directory.resolve("file"), "");
        for (Path wrong : List.of(file, file.resolve("below"))) {
            assertThatThrownBy(() -> Journal.in(wrong).check(Robot.MODELS))
                    .hasMessageStartingWith("the journal " + wrong + " cannot be written: ");
        }
    }

    @Test
    void modelsMayMove() {
        Rules moved = Robot.rules(Robot.models("/elsewhere/original.scxml", "Clean"), 8);

        assertThat(JournaledCore.recovered(moved, journal, clock))
                .isEqualTo(JournaledCore.recovered(Robot.RULES, journal, clock));
    }

    @Test
    void aSegmentThatWasOnlyBeingCreatedIsLeftOut() throws Exception {
        Files.write(journal.resolve("beginning"), new byte[500]);

        assertThat(JournaledCore.recovered(Robot.RULES, journal, clock)).isEqualTo(last);
        JournaledCore.in(journal).close();
        assertThat(journal.resolve("beginning")).doesNotExist();
    }

    /** A segment has its name only when it has its content; a power cut may have taken that again. */
    @Test
    void aBlankSegmentIsLeftOutOnlyAfterAPowerCut() throws Exception {
        Path blank = journal.resolve("0000000002.journal");
        Files.write(blank, new byte[500]);
        assertThatThrownBy(() -> JournaledCore.recovered(Robot.RULES, journal, clock))
                .hasMessageStartingWith(blank + ", byte 0: it is blank");

        byte[] killed = Files.readAllBytes(segmentIn(directory.resolve("killed")));
        Files.write(segmentIn(journal), inAnotherBoot(killed));
        assertThat(JournaledCore.recovered(Robot.RULES, journal, clock)).isEqualTo(last);
        assertThat(blank).doesNotExist();
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
