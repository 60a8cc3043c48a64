package org.evoloop.service;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayOutputStream;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.FutureTask;
import java.util.concurrent.TimeUnit;
import org.evoloop.time.SystemClock;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

@Timeout(60)
class WatchTest {
    private static final Duration SHORT = Duration.ofMillis(1);

    private final ByteArrayOutputStream screen = new ByteArrayOutputStream();
    private final SystemClock clock = new SystemClock();
    private final Watch watch = new Watch(new PrintStream(screen, true, StandardCharsets.UTF_8), clock);
    private int asked;

    @AfterEach
    void close() {
        clock.close();
    }

    @Test
    void eachAnswerIsDrawnInThePlaceOfTheLastUntilThereIsNone() throws Exception {
        int status = watch.run(
                results -> {
                    asked++;
                    results.println("answer " + asked);
                    return asked < 3 ? 0 : 2;
                },
                SHORT);

        assertThat(status).isEqualTo(2);
        assertThat(screen.toString(StandardCharsets.UTF_8))
                .startsWith("\033[2J\033[Hanswer 1\033[K\n(Ctrl-C ends it)\033[K\n\033[J\033[Hanswer 2\033[K\n")
                .doesNotContain("answer 3");
    }

    @Test
    void anInterruptEndsIt() throws Exception {
        CountDownLatch drawn = new CountDownLatch(1);
        FutureTask<Integer> watching = new FutureTask<>(() -> watch.run(
                results -> {
                    drawn.countDown();
                    return 0;
                },
                Duration.ofHours(1)));
        Thread thread = new Thread(watching, "watch-under-test");
        thread.start();
        assertThat(drawn.await(20, TimeUnit.SECONDS)).isTrue();
        thread.interrupt();
        assertThat(watching.get(20, TimeUnit.SECONDS)).isZero();
    }
}
