package org.evoloop.console;

import java.io.ByteArrayOutputStream;
import java.io.OutputStream;
import java.io.PrintStream;
import java.nio.charset.Charset;
import java.util.function.Consumer;

/**
 * Collects what is printed and hands it on in whole lines, so that it can be shown above a line that is being edited.
 * Output printed at once stays together.
 *
 * <p>Threading: used through its {@link #printer}, which is thread-safe.
 */
final class LineStream extends OutputStream {
    // The encoding of the loggers' output.
    private static final Charset CHARSET = Charset.defaultCharset();

    private final ByteArrayOutputStream lines = new ByteArrayOutputStream();
    private final Consumer<String> sink;

    private LineStream(Consumer<String> sink) {
        this.sink = sink;
    }

    /** A stream whose lines go to {@code sink}, without the final line end; closing it flushes the rest. */
    static PrintStream printer(Consumer<String> sink) {
        return new PrintStream(new LineStream(sink), true, CHARSET);
    }

    @Override
    public void write(int next) {
        if (next == '\n') {
            handOn();
        } else {
            lines.write(next);
        }
    }

    /** Hands on lines that come together in one call. */
    @Override
    public void write(byte[] bytes, int offset, int length) {
        int end = offset + length - 1;
        while (end >= offset && bytes[end] != '\n') {
            end--;
        }
        if (end >= offset) {
            lines.write(bytes, offset, end - offset);
            handOn();
        }
        lines.write(bytes, Math.max(offset, end + 1), offset + length - Math.max(offset, end + 1));
    }

    @Override
    public void close() {
        if (lines.size() > 0) {
            handOn();
        }
    }

    private void handOn() {
        String text = lines.toString(CHARSET).replace("\r\n", "\n");
        lines.reset();
        sink.accept(text.endsWith("\r") ? text.substring(0, text.length() - 1) : text);
    }
}
