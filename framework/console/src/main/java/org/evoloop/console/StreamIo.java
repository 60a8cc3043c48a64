package org.evoloop.console;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStream;
import java.io.InputStreamReader;
import java.io.PrintStream;
import java.nio.charset.Charset;
import java.time.Duration;
import java.util.Objects;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.FutureTask;
import java.util.function.Supplier;
import org.jspecify.annotations.Nullable;

/** Plain lines: no prompt, no echo. A line that is too long is reported, and skipped without being kept. */
final class StreamIo implements ConsoleIo {
    /** The longest line, in characters. */
    static final int LONGEST_LINE = 4095;

    private final BufferedReader in;
    private final PrintStream out;
    private final PrintStream err;

    StreamIo(InputStream in, PrintStream out, PrintStream err) {
        this.in = new BufferedReader(new InputStreamReader(in, Charset.defaultCharset()));
        this.out = out;
        this.err = err;
    }

    /** Reads on a separate thread, since nothing can interrupt the read of a pipe. */
    @Override
    public @Nullable String readLine() throws IOException, InterruptedException {
        FutureTask<@Nullable String> reading = new FutureTask<>(this::line);
        Thread reader = new Thread(reading, "evoloop-console-input");
        reader.setDaemon(true);
        reader.start();
        try {
            return reading.get();
        } catch (ExecutionException failure) {
            Throwable cause = Objects.requireNonNullElse(failure.getCause(), failure);
            throw new IOException("the input cannot be read: " + cause.getMessage(), cause);
        }
    }

    private @Nullable String line() throws IOException {
        StringBuilder line = new StringBuilder();
        boolean tooLong = false;
        for (int next = in.read(); next >= 0; next = in.read()) {
            if (next == '\n' || next == '\r') {
                if (!tooLong) {
                    return line.toString();
                }
                line.setLength(0);
                tooLong = false;
            } else if (line.length() < LONGEST_LINE) {
                line.append((char) next);
            } else if (!tooLong) {
                tooLong = true;
                err.println("error: the command is longer than " + LONGEST_LINE + " characters");
            }
        }
        return line.isEmpty() || tooLong ? null : line.toString();
    }

    @Override
    public PrintStream out() {
        return out;
    }

    @Override
    public PrintStream err() {
        return err;
    }

    @Override
    public boolean isTerminal() {
        return false;
    }

    @Override
    public void watch(Supplier<String> text, Duration period) {
        throw new IllegalStateException("watch needs a terminal, not a pipe");
    }

    @Override
    public void close() {
        out.flush();
        err.flush();
    }
}
