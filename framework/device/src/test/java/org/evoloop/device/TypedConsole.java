package org.evoloop.device;

import static org.awaitility.Awaitility.await;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.InterruptedIOException;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;

/** The standard input and output of a program in this process. */
final class TypedConsole {
    private final InputStream in = System.in;
    private final PrintStream out = System.out;
    private final ByteArrayOutputStream printed = new ByteArrayOutputStream();
    private final BlockingQueue<Byte> typed = new LinkedBlockingQueue<>();

    void redirect() {
        System.setIn(new Typed());
        System.setOut(new PrintStream(printed, true, StandardCharsets.UTF_8));
    }

    void restore() {
        System.setIn(in);
        System.setOut(out);
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
        await("history with " + line).until(() -> {
            type("history 20");
            return printed().contains(line);
        });
    }

    /** Waits until the status has this. */
    void awaitStatus(String part) {
        await("status with " + part).until(() -> {
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
