package org.evoloop.converter.changing;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.concurrent.CountDownLatch;
import java.util.concurrent.atomic.AtomicInteger;
import org.evoloop.converter.LiveRobot;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

@Timeout(60)
class StoppingTest {
    private final Stopping stopping = new Stopping("lamp");
    private final CountDownLatch stopped = new CountDownLatch(1);
    private final CountDownLatch mayEnd = new CountDownLatch(1);
    private final AtomicInteger runs = new AtomicInteger();

    private void rest() {
        runs.incrementAndGet();
        stopped.countDown();
        LiveRobot.awaitDeaf(mayEnd);
    }

    @Test
    void aStopIsNotLostThatComesWhileThePreviousOneEnds() throws InterruptedException {
        stopping.begin(this::rest, true);
        LiveRobot.await(stopped);
        // Meanwhile the converter may have been started again.
        stopping.begin(this::rest, true);
        mayEnd.countDown();
        stopping.await(false);
        assertThat(runs).hasValue(2);
    }

    @Test
    void severalOfThemAreOne() throws InterruptedException {
        stopping.begin(this::rest, true);
        LiveRobot.await(stopped);
        stopping.begin(this::rest, true);
        stopping.begin(this::rest, true);
        mayEnd.countDown();
        stopping.await(false);
        assertThat(runs).hasValue(2);
        assertThat(stopping.begin(this::rest, false)).isTrue();
        assertThat(runs).hasValue(3);
    }
}
