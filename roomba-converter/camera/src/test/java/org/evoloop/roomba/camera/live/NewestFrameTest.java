package org.evoloop.roomba.camera.live;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.TimeUnit;
import org.evoloop.roomba.camera.vision.Frame;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

@Timeout(20)
class NewestFrameTest {
    private final List<CountedFrame> rooms = new ArrayList<>();

    private NewestFrame frames(boolean everyFrameCounts) {
        return new NewestFrame(
                () -> {
                    rooms.add(new CountedFrame());
                    return rooms.get(rooms.size() - 1);
                },
                everyFrameCounts);
    }

    private static Frame publish(NewestFrame frames, long nanos) throws InterruptedException {
        Frame frame = frames.room();
        frames.publish(frame, nanos);
        return frame;
    }

    @Test
    void handsOutTheNewestAndNeverKeepsTheReaderWaiting() throws InterruptedException {
        NewestFrame frames = frames(false);
        publish(frames, 1);
        NewestFrame.Taken lookedAt = frames.take();
        for (int nanos = 2; nanos < 100; nanos++) {
            assertThat(publish(frames, nanos)).isNotSameAs(lookedAt.frame());
        }
        frames.giveBack(lookedAt.frame());

        assertThat(frames.take().nanos()).isEqualTo(99);
    }

    @Test
    void keepsTheReaderWaitingIfEveryFrameCounts() throws Exception {
        NewestFrame frames = frames(true);
        CompletableFuture<Void> reader = CompletableFuture.runAsync(() -> {
            try {
                for (int nanos = 0; nanos < 200; nanos++) {
                    publish(frames, nanos);
                }
            } catch (InterruptedException stop) {
                throw new AssertionError(stop);
            }
        });
        for (int nanos = 0; nanos < 200; nanos++) {
            NewestFrame.Taken taken = frames.take();
            assertThat(taken.nanos()).isEqualTo(nanos);
            frames.giveBack(taken.frame());
        }
        reader.get(10, TimeUnit.SECONDS);
    }

    @Test
    void closesEachFrameOnceWhereverItIs() throws InterruptedException {
        NewestFrame frames = frames(false);
        publish(frames, 1);
        Frame looking = frames.take().frame();
        publish(frames, 2);
        Frame reading = frames.room();

        frames.close();
        assertThat(rooms).filteredOn(frame -> frame.closed.get() == 1).hasSize(1);
        frames.publish(reading, 3);
        frames.giveBack(looking);

        assertThat(rooms)
                .hasSize(3)
                .allSatisfy(frame -> assertThat(frame.closed).hasValue(1));
        assertThatThrownBy(frames::take).isInstanceOf(InterruptedException.class);
        assertThatThrownBy(frames::room).isInstanceOf(InterruptedException.class);
    }
}
