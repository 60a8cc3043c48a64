package org.evoloop.journal;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.Random;
import java.util.concurrent.CompletableFuture;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/**
 * Whenever the process is killed: no effect happens twice, nothing accepted is lost, and the recorded state is the
 * device's.
 */
class KillTest {
    @TempDir
    private Path directory;

    @Test
    void someKills() throws Exception {
        kill("some", Forcing.BY_BATCH, 10);
    }

    @Test
    @Tag("slow")
    void manyKills() throws Exception {
        CompletableFuture<Void> other = CompletableFuture.runAsync(() -> kill("per-intent", Forcing.PER_INTENT, 170));
        kill("by-batch", Forcing.BY_BATCH, 330);
        other.get();
    }

    private void kill(String name, Forcing forcing, int times) {
        long seed = new Random().nextLong();
        Lives lives = new Lives(directory.resolve(name), forcing, seed);
        try {
            for (int life = 0; life < times; life++) {
                lives.liveAndBeKilled();
            }
            lives.liveToTheEnd();
            lives.check();
            System.out.printf("%d kills, %s, seed %d: %s%n", times, forcing, seed, lives);
            assertThat(Directory.segments(directory.resolve(name))).isNotEmpty();
        } catch (Throwable failed) {
            throw new AssertionError(forcing + ", seed " + seed + ", " + lives, failed);
        }
    }
}
