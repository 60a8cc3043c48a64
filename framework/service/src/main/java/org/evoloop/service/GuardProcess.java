package org.evoloop.service;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.util.Locale;
import java.util.function.Consumer;
import org.evoloop.time.Threads;

/**
 * One guard process, {@code device-guard.bash}. It runs in a separate session, so that signals that stop or end this
 * process do not affect it.
 *
 * <p>Threading: thread-safe. A separate thread reads its answers.
 */
final class GuardProcess {
    private static final String PROGRAM = program();

    private final Process process;

    /** @param answers receives each line of its output @throws IOException if it cannot be started */
    GuardProcess(Duration limit, String makeSafeCommand, Consumer<String> answers) throws IOException {
        String seconds = String.format(Locale.ROOT, "%.3f", limit.toNanos() / 1e9);
        process = new ProcessBuilder("setsid", "bash", "-c", PROGRAM, "evoloop-guard", seconds, makeSafeCommand)
                .redirectError(ProcessBuilder.Redirect.INHERIT)
                .start();
        Threads.start("evoloop-guard-" + process.pid(), () -> hear(answers));
    }

    private static String program() {
        try (InputStream file = GuardProcess.class.getResourceAsStream("device-guard.bash")) {
            if (file == null) {
                throw new AssertionError("the guard's program is not where its class is");
            }
            return new String(file.readAllBytes(), StandardCharsets.UTF_8);
        } catch (IOException unreadable) {
            throw new AssertionError("the guard's program cannot be read", unreadable);
        }
    }

    private void hear(Consumer<String> answers) {
        try (BufferedReader lines = process.inputReader(StandardCharsets.UTF_8)) {
            for (String line = lines.readLine(); line != null; line = lines.readLine()) {
                answers.accept(line);
            }
        } catch (IOException ended) {
            // isAlive() reports that.
        }
    }

    /** Sends a word; does nothing if the process has ended. */
    void send(String word) {
        try {
            OutputStream to = process.getOutputStream();
            to.write((word + "\n").getBytes(StandardCharsets.US_ASCII));
            to.flush();
        } catch (IOException ended) {
            // isAlive() reports that.
        }
    }

    boolean isAlive() {
        return process.isAlive();
    }

    long pid() {
        return process.pid();
    }

    /** Kills the process. */
    void kill() {
        process.destroyForcibly();
    }
}
