package org.evoloop.loop;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.concurrent.atomic.AtomicBoolean;
import java.util.concurrent.atomic.AtomicReference;
import org.evoloop.time.ManualClock;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/** Other monitors come and go while one reports. */
@Timeout(60)
class MonitorsUnderWayTest {
    private static final int CHANGES = 100_000;

    private static final class Silent extends Monitor<String> {
        Silent(String name) {
            super(name);
        }

        @Override
        protected @Nullable String getEvent() {
            return null;
        }
    }

    @Test
    void aMonitorIsPartOfTheLoopWhateverHappensToAnother() throws InterruptedException {
        Silent present = new Silent("present");
        AtomicBoolean over = new AtomicBoolean();
        AtomicReference<@Nullable Object> missed = new AtomicReference<>();
        try (MapeLoop<String, String, String> loop = new MapeLoop<>(
                LoopConfig.defaults("monitors", new ManualClock()).withoutThreads(), new Strict())) {
            loop.addMonitor(new Silent("other"));
            loop.addMonitor(present);
            Thread asking = new Thread(() -> {
                try {
                    while (!over.get() && missed.get() == null) {
                        missed.set(loop.has(present) ? null : "it is missing");
                    }
                } catch (RuntimeException thrown) {
                    missed.set(thrown);
                }
            });
            asking.start();
            for (int change = 0; change < CHANGES; change++) {
                loop.exchange("other", new Silent("other"));
            }
            over.set(true);
            asking.join();
        }
        assertThat(missed.get()).isNull();
    }

    private static final class Strict implements LoopListener<String> {
        @Override
        public void failed(Failure<String> failure) {
            throw new AssertionError(failure.toString(), failure.cause());
        }

        @Override
        public void dropped(String occurrence, boolean first) {
            throw new AssertionError(occurrence + " was dropped");
        }
    }
}
