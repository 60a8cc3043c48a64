package org.evoloop.device;

import static org.assertj.core.api.Assertions.assertThat;
import static org.awaitility.Awaitility.await;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.InterruptedIOException;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.extension.AfterEachCallback;
import org.junit.jupiter.api.extension.BeforeEachCallback;
import org.junit.jupiter.api.extension.ExtensionContext;

/** The standard input and output of a program in this process, for the time of a test. */
final class TypedConsole implements BeforeEachCallback, AfterEachCallback {
    /** Programs start slowly on a busy computer. */
    private static final Duration PATIENCE = Duration.ofSeconds(30);

    private final InputStream in = System.in;
    private final PrintStream out = System.out;
    private final ByteArrayOutputStream printed = new ByteArrayOutputStream();
    private final BlockingQueue<Byte> typed = new LinkedBlockingQueue<>();

    @Override
    public void beforeEach(ExtensionContext test) {
        System.setIn(new Typed());
        System.setOut(new PrintStream(printed, true, StandardCharsets.UTF_8));
    }

    @Override
    public void afterEach(ExtensionContext test) {
        System.setIn(in);
        System.setOut(out);
    }

    /** Runs a device file until it ends; the exit status. */
    CompletableFuture<Integer> run(Path file, String... options) {
        return CompletableFuture.supplyAsync(() -> DeviceProgram.run(file, List.of(options)));
    }

    /** Types {@code exit}, and waits for the program's end. */
    void exit(CompletableFuture<Integer> status) throws Exception {
        type("exit");
        assertThat(status.get(30, TimeUnit.SECONDS)).isZero();
    }

    void type(String line) {
        for (byte each : (line + "\n").getBytes(StandardCharsets.UTF_8)) {
            typed.add(each);
        }
    }

    String printed() {
        return printed.toString(StandardCharsets.UTF_8);
    }

    /** Waits until the history has this. */
    void awaitHistory(String line) {
        await("history with " + line).atMost(PATIENCE).until(() -> {
            type("history 20");
            return printed().contains(line);
        });
    }

    /** Waits until the status has this. */
    void awaitStatus(String part) {
        await("status with " + part).atMost(PATIENCE).until(() -> {
            type("status");
            return printed().contains(part);
        });
    }

    /** What is typed, whichever threads read it. */
    private final class Typed extends InputStream {
        @Override
        public int read() throws IOException {
            try {
                return typed.take();
            } catch (InterruptedException end) {
                throw new InterruptedIOException();
            }
        }

        @Override
        public int read(byte[] bytes, int from, int most) throws IOException {
            bytes[from] = (byte) read();
            return 1;
        }
    }
}
