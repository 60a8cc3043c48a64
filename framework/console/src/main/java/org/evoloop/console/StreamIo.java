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

/** Plain lines: no prompt, no echo. */
final class StreamIo implements ConsoleIo {
    private final BufferedReader lines;
    private final PrintStream out;
    private final PrintStream err;

    StreamIo(InputStream in, PrintStream out, PrintStream err) {
        this.lines = new BufferedReader(new InputStreamReader(in, Charset.defaultCharset()));
        this.out = out;
        this.err = err;
    }

    /** Reads on a separate thread, since nothing can interrupt the read of a pipe. */
    @Override
    public @Nullable String readLine() throws IOException, InterruptedException {
        FutureTask<@Nullable String> reading = new FutureTask<>(lines::readLine);
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
