package org.evoloop.console;

import java.io.ByteArrayOutputStream;
import java.io.OutputStream;
import java.io.PrintStream;
import java.nio.charset.Charset;
import java.util.function.Consumer;

/**
 * Collects what is printed and hands it on in whole lines, so that it can be shown above a line that is being edited.
 *
 * <p>Threading: used through its {@link #printer}, which is thread-safe.
 */
final class LineStream extends OutputStream {
    // What the loggers write is in this encoding.
    private static final Charset CHARSET = Charset.defaultCharset();

    private final ByteArrayOutputStream line = new ByteArrayOutputStream();
    private final Consumer<String> sink;

    private LineStream(Consumer<String> sink) {
        this.sink = sink;
    }

    /** A stream whose lines go to {@code sink}, without their ends; closing it hands on what is left. */
    static PrintStream printer(Consumer<String> sink) {
        return new PrintStream(new LineStream(sink), true, CHARSET);
    }

    @Override
    public void write(int next) {
        if (next == '\n') {
            handOn();
        } else {
            line.write(next);
        }
    }

    @Override
    public void close() {
        if (line.size() > 0) {
            handOn();
        }
    }

    private void handOn() {
        String text = line.toString(CHARSET);
        line.reset();
        sink.accept(text.endsWith("\r") ? text.substring(0, text.length() - 1) : text);
    }
}
