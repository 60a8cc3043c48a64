package org.evoloop.mqtt.edge;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** What is on the disk after a crash. */
class KeptTest {
    @TempDir
    private Path directory;

    @Test
    void whatIsKeptIsThereAgainAfterACrashAndNoNumberIsGivenTwice() throws Exception {
        Path kept = directory.resolve("kept");
        try (Outbox outbox = new Outbox(kept, 0)) {
            outbox.add("occurrence", "a", "{1}");
            outbox.add("effect", "b", "{2}\n{x}");
            outbox.sent(outbox.first(1, 1).get(0).number());
        }
        Files.writeString(kept.resolve("outbox"), "3\tocc", StandardOpenOption.APPEND);
        try (Outbox outbox = new Outbox(kept, 0)) {
            assertThat(outbox.first(9, 1)).containsExactly(new Outbox.Entry(2, "effect", "b", "{2} {x}"));
            outbox.add("occurrence", "a", "{3}");
            List<Outbox.Entry> all = new ArrayList<>(outbox.first(9, 1));
            assertThat(all).extracting(Outbox.Entry::number).containsExactly(2L, 3L);
            outbox.sent(all.get(1).number());
        }
        try (Outbox outbox = new Outbox(kept, 0)) {
            assertThat(outbox.size()).isZero();
            outbox.add("occurrence", "a", "{4}");
            assertThat(outbox.first(9, 1)).extracting(Outbox.Entry::number).containsExactly(4L);
        }
    }

    /** The clock, from which a new outbox counts on, is later each time. */
    @Test
    void whatWasNeverSentIsThereAgainWhenTheNextProgramStartsLater() throws Exception {
        try (Outbox outbox = new Outbox(directory, 1_000)) {
            outbox.add("occurrence", "a", "{1}");
            outbox.add("occurrence", "a", "{2}");
        }
        try (Outbox outbox = new Outbox(directory, 2_000)) {
            outbox.add("occurrence", "a", "{3}");
            assertThat(outbox.first(9, 1)).extracting(Outbox.Entry::number).containsExactly(1_001L, 1_002L, 1_003L);
            outbox.sent(1_002);
        }
        try (Outbox outbox = new Outbox(directory, 3_000)) {
            assertThat(outbox.first(9, 1)).containsExactly(new Outbox.Entry(1_003, "occurrence", "a", "{3}"));
        }
    }

    @Test
    void aRecordMayContainCarriageReturns() throws Exception {
        try (Outbox outbox = new Outbox(directory, 0)) {
            outbox.add("occurrence", "a", "{\r\n\"event\":\"switch\"\r\n}");
        }
        try (Outbox outbox = new Outbox(directory, 0)) {
            assertThat(outbox.first(9, 1))
                    .extracting(Outbox.Entry::record)
                    .containsExactly("{\r \"event\":\"switch\"\r }");
        }
    }

    /** While records always wait, their file shrinks nevertheless, and nothing that waits is lost. */
    @Test
    void theFileDoesNotGrowForever() throws Exception {
        String record = "{" + " ".repeat(10_000) + "}";
        try (Outbox outbox = new Outbox(directory, 0)) {
            outbox.write("occurrence", "a", "{}");
            for (int each = 1; each <= 1_000; each++) {
                outbox.write("occurrence", "a", record);
                outbox.force();
                outbox.sent(each);
            }
            assertThat(Files.size(directory.resolve("outbox"))).isLessThan(1_200_000);
            outbox.write("occurrence", "a", "{last}");
        }
        try (Outbox outbox = new Outbox(directory, 0)) {
            assertThat(outbox.first(9, 1))
                    .containsExactly(
                            new Outbox.Entry(1_001, "occurrence", "a", record),
                            new Outbox.Entry(1_002, "occurrence", "a", "{last}"));
        }
    }

    @Test
    void aDirectoryThatCannotBeUsedIsRefused() throws Exception {
        try (Outbox outbox = new Outbox(directory, 0)) {
            outbox.add("occurrence", "a", "{1}");
            assertThatThrownBy(() -> new Outbox(directory, 0))
                    .isInstanceOf(UncheckedIOException.class)
                    .hasMessage(directory + " cannot be used: another program uses it");
        }
        Files.writeString(directory.resolve("outbox.sent"), "");
        assertThatThrownBy(() -> new Outbox(directory, 0))
                .isInstanceOf(UncheckedIOException.class)
                .hasMessageContaining("outbox.sent is damaged: a number was expected, found ''");
    }

    @Test
    void aThreadThatIsToStopCanStillWrite() throws Exception {
        Path kept = directory.resolve("kept");
        try (Outbox outbox = new Outbox(kept, 0)) {
            Thread.currentThread().interrupt();
            outbox.add("occurrence", "a", "{1}");
            assertThat(Thread.interrupted()).isTrue();
            outbox.add("occurrence", "a", "{2}");
            assertThat(outbox.awaitAfter(1, 1)).isEqualTo(2);
        }
        try (Outbox outbox = new Outbox(kept, 0)) {
            assertThat(outbox.first(9, 1)).extracting(Outbox.Entry::record).containsExactly("{1}", "{2}");
        }
    }

    @Test
    void noCommandIsCarriedOutTwiceAfterACrash() {
        Path kept = directory.resolve("kept");
        assertThat(kept.toFile().mkdirs()).isTrue();
        try (LastCommands carried = new LastCommands(kept)) {
            assertThat(carried.take("a", 1)).isTrue();
            assertThat(carried.take("b", 7)).isTrue();
            assertThat(carried.take("a", 1)).isFalse();
        }
        try (LastCommands carried = new LastCommands(kept)) {
            assertThat(carried.take("b", 6)).isFalse();
            assertThat(carried.take("b", 7)).isFalse();
            assertThat(carried.take("a", 2)).isTrue();
        }
    }
}
