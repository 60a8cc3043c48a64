package org.evoloop.journal;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Path;
import java.time.Duration;
import java.time.Instant;
import org.evoloop.converter.HistoryEntry;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Presses that waited when a process was killed are not carried out long after. */
class OldPressesTest {
    @TempDir
    private Path directory;

    private Robots robot;

    @BeforeEach
    void pressFiveTimes() throws IOException, InterruptedException {
        robot = new Robots(directory);
        robot.converter.start();
        for (int press = 0; press < 5; press++) {
            robot.press("Clean");
        }
    }

    @AfterEach
    void close() {
        robot.close();
    }

    @Test
    void afterAnOutageNothingIsCarriedOut() throws Exception {
        robot.copy();
        robot.revive(Duration.ofSeconds(15));
        robot.converter.start();
        robot.settle();

        assertThat(robot.sent).isEmpty();
        assertThat(robot.states()).isEqualTo("(Off, Off)");
        assertThat(robot.outcomes()).hasSize(5).containsOnly("Clean STALE");
        assertThat(robot.converter.history()).allSatisfy(entry -> {
            assertThat(entry.observedAt()).isEqualTo(Instant.EPOCH);
            assertThat(entry.detail()).isEqualTo("pressed 15 s before its turn; the limit is 10 s");
        });
        robot.copyAndRevive();
        assertThat(robot.converter.history())
                .as("replayed")
                .hasSize(5)
                .extracting(HistoryEntry::detail)
                .containsOnly("pressed 15 s before its turn; the limit is 10 s");
    }

    @Test
    void afterAMomentTheyAre() throws Exception {
        robot.copy();
        robot.revive(Duration.ofSeconds(9));
        robot.converter.start();
        robot.settle();

        assertThat(robot.sent).isNotEmpty();
        assertThat(robot.outcomes()).doesNotContain("Clean STALE");
    }
}
