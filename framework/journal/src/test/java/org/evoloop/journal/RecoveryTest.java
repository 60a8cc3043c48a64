package org.evoloop.journal;

import static org.assertj.core.api.Assertions.assertThat;
import static org.awaitility.Awaitility.await;

import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.Random;
import java.util.stream.LongStream;
import org.evoloop.engine.Core;
import org.evoloop.engine.Input;
import org.evoloop.engine.Snapshot;
import org.evoloop.time.ManualClock;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** The state recovered after each record equals that of an uninterrupted core. */
class RecoveryTest {
    @TempDir
    private Path directory;

    static LongStream seeds() {
        return LongStream.concat(LongStream.rangeClosed(1, 4), LongStream.of(new Random().nextLong()));
    }

    @ParameterizedTest(name = "seed {0}")
    @MethodSource("seeds")
    void afterEveryRecord(long seed) throws Exception {
        Core uninterrupted = new Core(Robot.RULES, output -> {});
        try (JournaledCore kept = JournaledCore.in(directory.resolve("journal"))) {
            int inputs = 0;
            for (Input input : Story.of(Robot.RULES, new Random(seed), 80)) {
                kept.input(input);
                uninterrupted.apply(input);
                assertThat(kept.recovered(directory.resolve("copy" + inputs++)))
                        .as("after %s", input)
                        .isEqualTo(uninterrupted.snapshot());
            }
        }
    }

    @ParameterizedTest(name = "seed {0}")
    @MethodSource("seeds")
    void overManySegmentsOfWhichSomeAreDeleted(long seed) throws Exception {
        Path path = directory.resolve("journal");
        Journal small = Journal.in(path).withSegmentBytes(1 << 16).withKeptBytes(3 << 16);
        List<Input> story = Story.of(Robot.RULES, new Random(seed), 20_000);
        Core uninterrupted = new Core(Robot.RULES, output -> {});
        story.forEach(uninterrupted::apply);
        try (JournaledCore kept = new JournaledCore(path, small)) {
            kept.input(story);

            await().ignoreExceptions().until(() -> Directory.segments(path).size() == 2);
            assertThat(kept.recovered(directory.resolve("copy"))).isEqualTo(uninterrupted.snapshot());
            assertThat(kept.segment().getFileName().toString()).isGreaterThan("0000000005");
        }
    }

    @Test
    void aJournalThatWasClosedTakesNoMoreRoomThanItNeeds() throws Exception {
        JournaledCore kept = JournaledCore.in(directory);
        kept.input(Story.of(Robot.RULES, new Random(1), 100));
        Path segment = kept.segment();
        kept.close();

        assertThat(segment.toFile().length()).isLessThan(10_000);
    }

    /** A manual clock's time of day is the beginning of 1970 plus what it has advanced. */
    @Test
    void whatPassesWhileNoProcessRunsCounts() throws Exception {
        Snapshot last;
        try (JournaledCore kept = JournaledCore.in(directory)) {
            kept.input(new Input.Opened(10));
            last = kept.core.snapshot();
        }
        ManualClock threeSecondsLater = new ManualClock();
        threeSecondsLater.advance(Duration.ofSeconds(3));
        ManualClock back = new ManualClock();

        assertThat(JournaledCore.recovered(Robot.RULES, directory, threeSecondsLater))
                .isEqualTo(last);
        assertThat(JournaledCore.recovered(Robot.RULES, directory, back))
                .as("if the time of day went back, no time has passed")
                .isEqualTo(last.later(-10));
    }

    @Test
    void otherTimersAndCapacityAreThoseOfItsTime() throws Exception {
        try (JournaledCore kept = JournaledCore.in(directory)) {
            kept.input(Story.of(Robot.RULES, new Random(5), 200));
            Snapshot expected = kept.core.snapshot();
            Path copy = directory.resolve("copy");
            kept.copyTo(copy);

            assertThat(JournaledCore.recovered(Robot.rules(Robot.MODELS, 0), copy, kept.clock))
                    .isEqualTo(expected);
        }
    }
}
