package org.evoloop.roomba.camera.live;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.util.concurrent.CompletableFuture;
import java.util.concurrent.TimeUnit;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Test;

/** The scheduling of a thread as the kernel reports it. */
class BackgroundTest {
    @Test
    void aThreadInTheBackgroundIsContentWithLessAndNoOtherIs() throws Exception {
        assumeTrue(Background.current().isPresent(), "this system does not show how threads share its processors");
        int usual = onAThread(() -> {}).nice();
        assertThat(onAThread(Background::begin).nice()).isEqualTo(Math.max(usual, Background.NICE));
        assertThat(onAThread(() -> {}).nice()).isEqualTo(usual);
    }

    @Test
    void aThreadInTheBackgroundHasLongSlicesAndNoOtherHas() throws Exception {
        assumeTrue(knowsSlices(), "this kernel has no slices of a thread's own");
        assertThat(onAThread(Background::begin).sliceNanos()).isEqualTo(Background.SLICE_NANOS);
        assertThat(onAThread(() -> {}).sliceNanos()).isLessThan(Background.SLICE_NANOS);
    }

    @Test
    void beginningTwiceIsBeginningOnce() throws Exception {
        assumeTrue(Background.current().isPresent(), "this system does not show how threads share its processors");
        Background.Share once = onAThread(Background::begin);
        assertThat(onAThread(() -> {
                    Background.begin();
                    Background.begin();
                }))
                .isEqualTo(once);
    }

    private static Background.Share onAThread(Runnable asking) throws Exception {
        CompletableFuture<Background.Share> share = new CompletableFuture<>();
        Thread thread = new Thread(() -> {
            try {
                asking.run();
                share.complete(Background.current().orElseThrow());
            } catch (Throwable failure) {
                share.completeExceptionally(failure);
            }
        });
        thread.start();
        return share.get(10, TimeUnit.SECONDS);
    }

    /** Linux 6.12 and later. */
    private static boolean knowsSlices() {
        Matcher version = Pattern.compile("(\\d+)\\.(\\d+).*").matcher(System.getProperty("os.version"));
        return System.getProperty("os.name").equals("Linux")
                && version.matches()
                && Integer.parseInt(version.group(1)) * 1000 + Integer.parseInt(version.group(2)) >= 6012
                && Background.current().isPresent();
    }
}
