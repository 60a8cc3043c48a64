package org.evoloop.link;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.List;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/** How long a link waits before it closes; a pseudo-terminal, unlike a UART, never says that bytes are waiting. */
@Timeout(30)
class SerialWriterTest {
    private static final Duration LIMIT = Duration.ofSeconds(20);

    private final Deque<Integer> waiting = new ArrayDeque<>();
    private final SerialWriter writer = new SerialWriter(
            new SerialWriter.Port() {
                @Override
                public int write(byte[] bytes) {
                    return bytes.length;
                }

                @Override
                public int waiting() {
                    return waiting.size() > 1 ? waiting.remove() : waiting.getFirst();
                }
            },
            new SerialSettings("ttyS9"),
            () -> {},
            "unused");

    private final CountDownLatch ended = new CountDownLatch(1);

    private void awaitSilence(Duration limit) {
        writer.awaitSilence(limit.toNanos(), nanos -> ended.await(nanos, TimeUnit.NANOSECONDS));
    }

    @Test
    void aPortWhoseDriverHasBytesLeftIsNotClosedYet() {
        waiting.addAll(List.of(700, 300, 1, 0));
        awaitSilence(LIMIT);
        assertThat(waiting).containsExactly(0);
    }

    @Test
    void aDriverThatDoesNotKnowIsNotWaitedFor() {
        waiting.add(-1);
        awaitSilence(LIMIT);
        assertThat(waiting).containsExactly(-1);
    }

    @Test
    void bytesThatNeverLeaveAreWaitedForOnlyUpToTheLimit() {
        waiting.add(512);
        awaitSilence(Duration.ofMillis(50));
        assertThat(waiting).containsExactly(512);
    }

    @Test
    void aLinkThatHasEndedIsNotWaitedFor() {
        waiting.add(512);
        ended.countDown();
        awaitSilence(LIMIT);
        assertThat(waiting).containsExactly(512);
    }
}
