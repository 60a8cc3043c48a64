package org.evoloop.journal;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.List;
import java.util.Random;
import java.util.stream.LongStream;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** Every recorded run is the same when it is replayed with the models that it was recorded with, and so is a shadow. */
class SameModelsReplayTest {
    @TempDir
    private Path directory;

    static LongStream seeds() {
        return LongStream.concat(LongStream.rangeClosed(1, 60), LongStream.of(new Random().nextLong()));
    }

    @ParameterizedTest(name = "seed {0}")
    @MethodSource("seeds")
    void decidesTheSame(long seed) throws InterruptedException {
        try (RandomLife life = new RandomLife(directory, new Random(seed))) {
            life.live(250);
            life.shadowAgrees();
            DryRun.Result result = DryRun.of(new JournalFiles(life.journal()), RandomLife.models(), List.of());
            assertThat(result.differences()).as("seed %d", seed).isEmpty();
            assertThat(result.notes()).as("seed %d", seed).isEmpty();
            assertThat(result.events()).as("seed %d", seed).isPositive();
        }
    }
}
