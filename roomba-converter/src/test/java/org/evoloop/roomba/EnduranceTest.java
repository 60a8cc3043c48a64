package org.evoloop.roomba;

import static org.assertj.core.api.Assertions.assertThat;
import static org.awaitility.Awaitility.await;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.evoloop.link.MemoryLink;
import org.evoloop.roomba.oi.StreamFrame;
import org.evoloop.roomba.session.RoombaSession;
import org.evoloop.roomba.session.SessionListener;
import org.evoloop.roomba.session.SessionOptions;
import org.evoloop.roomba.session.Telemetry;
import org.evoloop.roomba.simulator.SimulatorServer;
import org.evoloop.roomba.simulator.robot.RobotActivity;
import org.evoloop.roomba.simulator.robot.RobotOptions;
import org.evoloop.roomba.simulator.robot.SimulatedRoomba;
import org.evoloop.time.Clock;
import org.evoloop.time.SystemClock;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;

/** Long operation on a noisy line, and a cable that is pulled repeatedly. */
class EnduranceTest {
    private static final Duration LIMIT = Duration.ofSeconds(30);
    private static final long FRAME_BYTES = StreamFrame.length(RoombaSession.STREAM);

    @Test
    void hearsNothingWrongInTenMinutesOnANoisyLine() {
        cleanOnANoisyLine(Duration.ofMinutes(10));
    }

    @Test
    @Tag("slow")
    void hearsNothingWrongInAnHourOnANoisyLine() {
        cleanOnANoisyLine(Duration.ofHours(1));
    }

    private static void cleanOnANoisyLine(Duration duration) {
        try (SteppedRoomba stepped = new SteppedRoomba(RobotOptions.defaults())) {
            stepped.press(RobotEvents.CLEAN);
            stepped.advance(Duration.ofSeconds(1));
            stepped.press(RobotEvents.CLEAN);
            stepped.advance(Duration.ofSeconds(1));
            int events = stepped.roomba.converter().history().size();
            Counts before = Counts.of(stepped);
            LongestGap gap = new LongestGap(stepped.clock);
            stepped.roomba.session().addListener(gap);
            stepped.disturb(new MemoryLink.Noise(7, 0.01, 0.01));

            stepped.advance(duration);

            assertThat(stepped.roomba.converter().history())
                    .as("no wrong event")
                    .hasSize(events);
            assertThat(stepped.states().original().name()).isEqualTo("Clean");
            assertThat(stepped.truth().activity()).isEqualTo(RobotActivity.CLEAN);
            assertThat(stepped.roomba.session().isUp()).isTrue();
            assertThat(gap.longestNanos).as("no stall").isPositive().isLessThan(1_000_000_000);
            Counts after = Counts.of(stepped);
            long spoilt = duration.toMillis() / SimulatedRoomba.TICK_MILLIS - (after.frames() - before.frames());
            assertThat(spoilt).as("the line is really noisy").isPositive();
            assertThat(after.bad()).isGreaterThan(before.bad());
            // One byte in a hundred is lost and cannot be counted.
            assertThat(after.skippedBytes() - before.skippedBytes())
                    .as("the bytes of every corrupted frame are counted")
                    .isBetween((long) (spoilt * FRAME_BYTES * 0.95), spoilt * FRAME_BYTES);
        }
    }

    /** The status's counts of received frames. */
    private record Counts(long frames, long bad, long skippedBytes) {
        private static final Pattern TEXT = Pattern.compile("(\\d+) frames, (\\d+) bad, (\\d+) bytes skipped");

        static Counts of(SteppedRoomba stepped) {
            Matcher counts =
                    TEXT.matcher(stepped.roomba.converter().status().link().text());
            assertThat(counts.find()).isTrue();
            return new Counts(
                    Long.parseLong(counts.group(1)), Long.parseLong(counts.group(2)), Long.parseLong(counts.group(3)));
        }
    }

    /** The longest time without a frame. */
    private static final class LongestGap implements SessionListener {
        private final Clock clock;
        private long lastNanos;
        private long longestNanos;

        LongestGap(Clock clock) {
            this.clock = clock;
            this.lastNanos = clock.nanoTime();
        }

        @Override
        public void received(Telemetry telemetry) {
            longestNanos = Math.max(longestNanos, clock.nanoTime() - lastNanos);
            lastNanos = clock.nanoTime();
        }
    }

    @Test
    @Timeout(120)
    @EnabledOnOs(OS.LINUX)
    void comesBackAfterEveryReplug(@TempDir Path folder) throws IOException, InterruptedException {
        pullAgainAndAgain(folder, 10);
    }

    @Test
    @Tag("slow")
    @Timeout(600)
    @EnabledOnOs(OS.LINUX)
    void comesBackAfterAHundredReplugs(@TempDir Path folder) throws IOException, InterruptedException {
        pullAgainAndAgain(folder, 100);
    }

    private static void pullAgainAndAgain(Path folder, int times) throws IOException, InterruptedException {
        Path port = folder.resolve("roomba");
        try (Clock clock = new SystemClock();
                SimulatorServer server = SimulatorServer.start(port, RobotOptions.defaults(), clock, 1);
                RoombaSession session =
                        new RoombaSession(RoombaCommand.cable(port.toString()), clock, SessionOptions.defaults())) {
            session.open();
            session.awaitRobot();
            pull(server, session);
            int threads = Thread.activeCount();
            long descriptors = descriptors();
            for (int time = 0; time < times; time++) {
                pull(server, session);
            }
            // What the last cable needed may end after the first frame over the next one.
            await().atMost(LIMIT).pollInSameThread().untilAsserted(() -> {
                assertThat(Thread.activeCount()).isLessThanOrEqualTo(threads);
                assertThat(descriptors()).isLessThanOrEqualTo(descriptors);
            });
        }
    }

    /** Pulls the cable, plugs it in again, and waits for the first frame after that. */
    private static void pull(SimulatorServer server, RoombaSession session) throws IOException, InterruptedException {
        CountDownLatch frame = new CountDownLatch(1);
        AtomicBoolean replugged = new AtomicBoolean();
        SessionListener listener = new SessionListener() {
            @Override
            public void received(Telemetry telemetry) {
                if (replugged.get()) {
                    frame.countDown();
                }
            }
        };
        session.addListener(listener);
        server.unplug();
        while (session.isUp()) {
            Thread.onSpinWait();
        }
        replugged.set(true);
        server.replug();
        assertThat(frame.await(LIMIT.toSeconds(), TimeUnit.SECONDS)).as("back").isTrue();
        session.removeListener(listener);
    }

    private static long descriptors() throws IOException {
        try (var open = Files.list(Path.of("/proc/self/fd"))) {
            return open.count();
        }
    }
}
