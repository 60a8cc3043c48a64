package org.evoloop.service;

import static org.assertj.core.api.Assertions.assertThat;
import static org.awaitility.Awaitility.await;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;

/** With a real guard process. GuardedRobotTest covers what it does when this process is killed or stopped. */
@Timeout(value = 60, threadMode = Timeout.ThreadMode.SEPARATE_THREAD)
@EnabledOnOs(OS.LINUX)
class DeviceGuardTest {
    @TempDir
    private Path folder;

    /** A device that leaves a file when it is made safe. */
    private final class Device implements GuardedDevice {
        private final LinkedBlockingQueue<String> reasons = new LinkedBlockingQueue<>();
        private final CountDownLatch proceed = new CountDownLatch(1);
        private volatile boolean active;
        private volatile boolean hangs;

        @Override
        public String makeSafeCommand() {
            return "echo safe >> " + mark();
        }

        @Override
        public boolean isActive() {
            if (hangs) {
                try {
                    proceed.await();
                } catch (InterruptedException end) {
                    Thread.currentThread().interrupt();
                }
            }
            return active;
        }

        @Override
        public void madeSafe(String reason) {
            active = false;
            reasons.add(reason);
        }
    }

    private Path mark() {
        return folder.resolve("mark");
    }

    /** The guard process, as {@code describe} names it. */
    private static ProcessHandle processOf(DeviceGuard guard) {
        String words = guard.describe();
        return ProcessHandle.of(Long.parseLong(words.substring(words.lastIndexOf(' ') + 1)))
                .orElseThrow();
    }

    @Test
    void afterADisconnectionTheDeviceIsMadeSafeAndSentNothingBeforeThatIsKnown() throws Exception {
        Device device = new Device();
        try (DeviceGuard guard = DeviceGuard.start(device)) {
            device.active = true;
            assertThat(guard.maySend()).isTrue();
            device.hangs = true;
            await().until(() -> Files.exists(mark()));
            assertThat(guard.maySend()).isFalse();
            device.hangs = false;
            device.proceed.countDown();
            assertThat(device.reasons.poll(30, TimeUnit.SECONDS)).contains("so the device was put into a safe state");
            await().until(guard::maySend);
        }
        assertThat(Files.readAllLines(mark())).as("once").containsExactly("safe");
    }

    @Test
    void aDeviceThatIsNotActiveIsNotWatched() throws Exception {
        Device device = new Device();
        try (DeviceGuard guard = DeviceGuard.start(device)) {
            assertThat(guard.describe()).matches("guarded by process \\d+");
            device.hangs = true;
            assertThat(device.reasons.poll(2 * DeviceGuard.LIMIT.toMillis(), TimeUnit.MILLISECONDS))
                    .isNull();
            device.proceed.countDown();
        }
        assertThat(mark()).doesNotExist();
    }

    @Test
    void aGuardProcessThatIsKilledIsReplaced() throws Exception {
        Device device = new Device();
        device.active = true;
        try (DeviceGuard guard = DeviceGuard.start(device)) {
            ProcessHandle first = processOf(guard);
            first.destroyForcibly();
            first.onExit().get(30, TimeUnit.SECONDS);
            await().until(() ->
                    guard.describe().startsWith("guarded") && !guard.describe().endsWith(" " + first.pid()));
        }
        // If this process gets no processor time for half a second, its device is rightly made safe.
        if (device.reasons.isEmpty()) {
            assertThat(mark()).doesNotExist();
        }
    }

    @Test
    void aGuardProcessThatIsFrozenIsReplacedWhileTheDeviceIsActive() throws Exception {
        Device device = new Device();
        device.active = true;
        try (DeviceGuard guard = DeviceGuard.start(device)) {
            ProcessHandle first = processOf(guard);
            // A process that has just started may take longer.
            await().until(guard::isAnswered);
            assertThat(new ProcessBuilder("bash", "-c", "kill -STOP " + first.pid())
                            .start()
                            .waitFor())
                    .isZero();
            // Within a second; a busy computer gets some more.
            first.onExit().get(4, TimeUnit.SECONDS);
            await().until(() -> !guard.describe().endsWith(" " + first.pid()) && guard.isAnswered());
        }
    }

    @Test
    void whatCannotBeDoneAtOnceIsTriedAgain() throws IOException, InterruptedException {
        Path port = folder.resolve("port");
        Process guard = new ProcessBuilder(
                        "bash", "-c", program(), "evoloop-guard", "0.5", "[ -e " + port + " ] && echo safe > " + mark())
                .redirectError(ProcessBuilder.Redirect.DISCARD)
                .start();
        guard.getOutputStream().close();
        assertThat(guard.waitFor(Duration.ofMillis(300).toMillis(), TimeUnit.MILLISECONDS))
                .isFalse();
        Files.createFile(port);
        assertThat(guard.waitFor(30, TimeUnit.SECONDS)).isTrue();
        assertThat(mark()).exists();
    }

    private static String program() throws IOException {
        return new String(
                DeviceGuard.class.getResourceAsStream("device-guard.bash").readAllBytes(), StandardCharsets.UTF_8);
    }
}
