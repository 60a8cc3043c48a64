package org.evoloop.roomba;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicBoolean;
import org.evoloop.roomba.link.MemoryLink;
import org.evoloop.roomba.session.RoombaSession;
import org.evoloop.roomba.session.SessionListener;
import org.evoloop.roomba.session.SessionOptions;
import org.evoloop.roomba.session.Telemetry;
import org.evoloop.roomba.simulator.SimulatorServer;
import org.evoloop.roomba.simulator.robot.Activity;
import org.evoloop.roomba.simulator.robot.RobotOptions;
import org.evoloop.time.Clock;
import org.evoloop.time.SystemClock;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;

/** A long time on a bad line, and a cable that is pulled again and again. */
class EnduranceTest {

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
            stepped.disturb(new MemoryLink.Noise(7, 0.01, 0.01));

            stepped.advance(duration);

            assertThat(stepped.roomba.converter().history()).hasSize(events);
            assertThat(stepped.states().original().name()).isEqualTo("Clean");
            assertThat(stepped.truth().activity()).isEqualTo(Activity.CLEAN);
            assertThat(stepped.roomba.session().isUp()).isTrue();
            assertThat(stepped.roomba.converter().status().link().text())
                    .containsPattern("[1-9][0-9]* bad, [1-9][0-9]* bytes skipped");
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
            assertThat(Thread.activeCount()).isLessThanOrEqualTo(threads);
            assertThat(descriptors()).isLessThanOrEqualTo(descriptors);
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
        assertThat(frame.await(2, TimeUnit.SECONDS)).as("back within 2 s").isTrue();
        session.removeListener(listener);
    }

    private static long descriptors() throws IOException {
        try (var open = Files.list(Path.of("/proc/self/fd"))) {
            return open.count();
        }
    }
}
