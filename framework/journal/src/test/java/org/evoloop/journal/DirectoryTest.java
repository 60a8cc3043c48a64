package org.evoloop.journal;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.evoloop.engine.Input;
import org.evoloop.evolution.Occurrence;
import org.evoloop.evolution.Source;
import org.evoloop.evolution.Values;
import org.evoloop.statemachine.Event;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;

/** A journal whose directory is shared, unusable or missing. */
class DirectoryTest {
    @TempDir
    private Path directory;

    @Test
    void oneConverterHoldsIt() {
        try (JournaledCore kept = JournaledCore.in(directory)) {
            assertThatThrownBy(() -> JournaledCore.in(directory))
                    .isInstanceOf(JournalException.class)
                    .hasMessage("the journal " + directory
                            + " is in use by another converter; close that one, or use another directory");
            assertThat(kept.failures).isEmpty();
        }
        JournaledCore.in(directory).close();
    }

    @Test
    void aFileIsNoDirectory() throws Exception {
        Path file = Files.writeString(directory.resolve("file"), "");

        assertThatThrownBy(() -> JournaledCore.in(file))
                .isInstanceOf(JournalException.class)
                .hasMessageStartingWith("the journal " + file + " cannot be written: ")
                .hasMessageEndingWith(
                        "make it a directory that this user may write to, with room on its disk, or use another");
    }

    /** Not even the superuser can write there. */
    @Test
    @EnabledOnOs(OS.LINUX)
    void aReadOnlyDiskIsRefused() {
        Path file = Path.of("/proc/evoloop");

        assertThatThrownBy(() -> JournaledCore.in(file))
                .hasMessageStartingWith("the journal /proc/evoloop cannot be written: ");
    }

    @Test
    void optionsOutOfRangeAreRefused() {
        assertThatThrownBy(() -> Journal.in(directory).withSegmentBytes(5))
                .hasMessage("segmentBytes is 5, allowed is 65536 to 1073741824");
        assertThatThrownBy(() -> Journal.in(directory).withKeptBytes(-1))
                .hasMessage("keptBytes is -1, allowed is 0 and more");
    }

    @Test
    void whileNothingCanBeWrittenNothingIsBegun() throws Exception {
        Path path = directory.resolve("journal");
        Path away = directory.resolve("away");
        try (JournaledCore kept = new JournaledCore(path, Journal.in(path).withSegmentBytes(1 << 16))) {
            kept.input(List.of(new Input.Opened(1), press(2), new Input.Ready(), planned(kept, 3)));
            Files.move(path, away);
            fill(kept);

            assertThat(kept.failures).singleElement().asString().contains("the journal " + path + " cannot be written");
            assertThatThrownBy(() -> kept.input(new Input.Sending(1)))
                    .isInstanceOf(JournalException.class)
                    .hasMessageEndingWith("cannot be written, so nothing is sent; make room on its disk");
            long refused = kept.core.tally().refused();
            kept.input(press(4));
            assertThat(kept.core.tally().refused()).isEqualTo(refused + 1);
            kept.input(new Input.Observed(
                    new Occurrence.Found(Robot.RULES.table().models().initial().original(), 5)));
            assertThat(kept.core.tally().observed())
                    .isEqualTo(kept.core.tally().dropped() + kept.core.tally().refused() + 1);
        }
    }

    private static Input press(long atNanos) {
        return new Input.Observed(new Occurrence.Heard(new Event("Clean"), Values.NONE, Source.CONTROLLER, 0, atNanos));
    }

    private static Input planned(JournaledCore kept, long atNanos) {
        return new Input.Planned(
                1, Robot.RULES.table().decide(Robot.MODELS.initial(), new Event("Clean"), false), atNanos);
    }

    /** Fills the segment until another one is needed. */
    private static void fill(JournaledCore kept) {
        while (kept.failures.isEmpty()) {
            kept.input(new Input.Dismissed(99, 3));
        }
    }
}
