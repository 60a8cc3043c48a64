package org.evoloop.roomba.camera.live;

import static org.assertj.core.api.Assertions.assertThat;
import static org.awaitility.Awaitility.await;

import java.time.Duration;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.Supplier;
import org.evoloop.roomba.camera.CameraException;
import org.evoloop.roomba.camera.CameraHealth.Condition;
import org.evoloop.roomba.camera.CameraSource;
import org.evoloop.roomba.camera.vision.Frame;
import org.evoloop.roomba.camera.vision.FrameReader;
import org.evoloop.roomba.camera.vision.FrameReader.Received;
import org.evoloop.time.ManualClock;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/** What the thread that owns a camera does when the camera misbehaves, with a stopped clock. */
@Timeout(30)
class GrabberTest {
    private final ManualClock clock = new ManualClock();
    private final HealthTracker health = new HealthTracker("camera x", Duration.ofMillis(300));
    private final NewestFrame frames = new NewestFrame(CountedFrame::new, false);
    private final AtomicInteger opened = new AtomicInteger();
    private final AtomicInteger closed = new AtomicInteger();
    private final LinkedBlockingQueue<Supplier<Received>> script = new LinkedBlockingQueue<>();
    private Grabber grabber;
    private Thread thread;

    @AfterEach
    void stop() throws InterruptedException {
        grabber.stop();
        thread.interrupt();
        thread.join(TimeUnit.SECONDS.toMillis(10));
        assertThat(thread.isAlive()).isFalse();
        assertThat(closed).hasValue(opened.get());
    }

    private final class Reader implements FrameReader {
        Reader() {
            opened.incrementAndGet();
        }

        @Override
        public Received read(Frame into) {
            try {
                return script.take().get();
            } catch (InterruptedException stop) {
                Thread.currentThread().interrupt();
                return Received.NOTHING;
            }
        }

        @Override
        public void close() {
            closed.incrementAndGet();
        }
    }

    private void start(Supplier<FrameReader> opener) {
        grabber = new Grabber(CameraSource.parse("http://x/"), opener, clock, health, frames);
        thread = new Thread(grabber, "grabber");
        thread.start();
    }

    private void say(Received... outcomes) {
        for (Received outcome : outcomes) {
            script.add(() -> outcome);
        }
    }

    private void awaitPause() {
        await().atMost(10, TimeUnit.SECONDS).until(() -> clock.pendingTasks() == 1);
    }

    @Test
    void waitsTwiceAsLongAfterEachFailureToOpen() {
        AtomicInteger tried = new AtomicInteger();
        start(() -> {
            tried.incrementAndGet();
            throw new CameraException("not there; plug it in");
        });
        int pauseMillis = 250;
        for (int attempt = 1; attempt < 9; attempt++) {
            awaitPause();
            assertThat(tried).hasValue(attempt);
            assertThat(health.at(clock.nanoTime()).state()).isEqualTo(Condition.GONE);
            clock.advance(Duration.ofMillis(pauseMillis - 1));
            assertThat(clock.pendingTasks()).isOne();
            clock.advance(Duration.ofMillis(1));
            int next = attempt + 1;
            await().atMost(10, TimeUnit.SECONDS).until(() -> tried.get() == next);
            pauseMillis = Math.min(8000, 2 * pauseMillis);
        }
    }

    @Test
    void opensAgainAfterFiveFailedReads() throws InterruptedException {
        start(Reader::new);
        say(Received.FRAME);
        frames.giveBack(frames.take().frame());
        say(Received.NOTHING, Received.NOTHING, Received.NOTHING, Received.NOTHING, Received.NOTHING);

        awaitPause();
        assertThat(closed).hasValue(1);
        assertThat(health.at(0).state()).isEqualTo(Condition.GONE);
        assertThat(grabber.damagedFrames()).isZero();
        clock.advance(Duration.ofMillis(250));
        say(Received.FRAME);
        frames.giveBack(frames.take().frame());
        assertThat(opened).hasValue(2);
    }

    @Test
    void takesAFailedReadThatFramesFollowForADamagedFrame() throws InterruptedException {
        start(Reader::new);
        say(Received.NOTHING, Received.NOTHING, Received.DAMAGED, Received.FRAME);
        frames.giveBack(frames.take().frame());
        assertThat(grabber.damagedFrames()).isEqualTo(3);
        assertThat(opened).hasValue(1);
    }

    @Test
    void opensAgainAfterAReadThatTookLongAndFailed() {
        start(Reader::new);
        script.add(() -> {
            clock.advance(Duration.ofSeconds(4));
            return Received.NOTHING;
        });
        awaitPause();
        assertThat(closed).hasValue(1);
    }

    @Test
    void opensAgainWhatSendsDamagedFramesOnly() {
        start(Reader::new);
        for (int i = 0; i < 6; i++) {
            script.add(() -> {
                clock.advance(Duration.ofSeconds(1));
                return Received.DAMAGED;
            });
        }
        awaitPause();
        assertThat(closed).hasValue(1);
        assertThat(grabber.damagedFrames()).isEqualTo(6);
    }
}
