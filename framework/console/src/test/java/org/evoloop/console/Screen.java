package org.evoloop.console;

import java.io.ByteArrayOutputStream;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;

/** A terminal's output; a test can wait here for some text. */
final class Screen extends OutputStream {
    private static final long PATIENCE_MILLIS = 20_000;

    private final ByteArrayOutputStream shown = new ByteArrayOutputStream();
    private int seen;

    @Override
    public synchronized void write(int next) {
        shown.write(next);
        notifyAll();
    }

    /** Waits for {@code text} after the text that earlier calls waited for; fails if it never comes. */
    synchronized void await(String text) throws InterruptedException {
        long deadline = System.nanoTime() + PATIENCE_MILLIS * 1_000_000;
        int at = text().indexOf(text, seen);
        while (at < 0) {
            long leftMillis = (deadline - System.nanoTime()) / 1_000_000;
            if (leftMillis <= 0) {
                throw new AssertionError("'" + text + "' was not shown after position " + seen + " of: " + text());
            }
            wait(leftMillis);
            at = text().indexOf(text, seen);
        }
        seen = at + text.length();
    }

    synchronized String text() {
        // One character per byte, so that positions stay correct.
        return shown.toString(StandardCharsets.ISO_8859_1);
    }
}
