package org.evoloop.converter.binding;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.concurrent.atomic.AtomicInteger;
import org.evoloop.evolution.Values;
import org.evoloop.loop.LoopConfig;
import org.evoloop.time.ManualClock;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

@Timeout(60)
class GuardWatchTest {
    private static final int ROUNDS = 50_000;

    private final ManualClock clock = new ManualClock();
    private final LoopConfig config = LoopConfig.defaults("lamp", clock);
    private final GuardWatch watch = new GuardWatch("dark", config, (part, failure) -> {});
    private final AtomicInteger refused = new AtomicInteger();
    private final AtomicInteger arrived = new AtomicInteger();
    private volatile int round;

    @Test
    void aGuardThatNobodyAskedForLongIsNotTakenToHang() throws Exception {
        Thread other = new Thread(this::ask);
        other.start();
        ask();
        other.join();
        assertThat(refused).hasValue(0);
    }

    private void ask() {
        for (int next = 1; next <= ROUNDS; next++) {
            beginTogether(next);
            try {
                watch.test(values -> true, Values.NONE, true);
            } catch (IllegalStateException hangs) {
                refused.incrementAndGet();
            }
        }
    }

    /** Two threads that wait at a lock would not be woken at the same time. */
    private void beginTogether(int next) {
        if (arrived.incrementAndGet() == 2 * next) {
            clock.advance(config.stepLimit().plusNanos(1));
            round = next;
        }
        while (round < next) {
            Thread.onSpinWait();
        }
    }
}
