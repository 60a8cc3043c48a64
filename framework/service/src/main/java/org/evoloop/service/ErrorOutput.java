package org.evoloop.service;

import java.io.FilterOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.io.PrintStream;
import java.nio.charset.Charset;
import java.nio.file.Files;
import java.nio.file.Path;
import org.jspecify.annotations.Nullable;

/**
 * The output for a program's final error: standard error. If systemd's journal reads it, each line begins with the
 * level of an error (sd-daemon(3)), as in {@link ProgramLog}.
 *
 * <p>Threading: {@link #stream} may be called by any thread.
 *
 * @since 0.1
 */
public final class ErrorOutput {
    /** Standard error as a file of the process; a link to its socket or file. */
    private static final Path STANDARD_ERROR = Path.of("/proc/self/fd/2");

    private ErrorOutput() {}

    /** A stream for error messages. It writes to the current {@link System#err}, and is flushed after each line. */
    public static PrintStream stream() {
        return isJournal() ? levelled(System.err) : System.err;
    }

    /** Whether systemd's journal reads the standard error. */
    static boolean isJournal() {
        return isJournal(STANDARD_ERROR, System.getenv("JOURNAL_STREAM"));
    }

    /**
     * Whether the journal reads {@code stream}.
     *
     * @param journalStream the variable {@code JOURNAL_STREAM}: {@code DEVICE:INODE} of the stream that systemd opened.
     *     A program whose output was redirected has inherited the variable, but not the stream
     */
    static boolean isJournal(Path stream, @Nullable String journalStream) {
        if (journalStream == null) {
            return false;
        }
        try {
            return journalStream.equals(
                    Files.getAttribute(stream, "unix:dev") + ":" + Files.getAttribute(stream, "unix:ino"));
        } catch (IOException | UnsupportedOperationException | IllegalArgumentException unknown) {
            return false;
        }
    }

    static PrintStream levelled(PrintStream out) {
        return new PrintStream(new Levelled(out), true, Charset.defaultCharset());
    }

    /** Begins each line with the level of an error. */
    private static final class Levelled extends FilterOutputStream {
        private static final byte[] ERROR = {'<', '3', '>'};

        private boolean beginsLine = true;

        private Levelled(OutputStream out) {
            super(out);
        }

        @Override
        public void write(int octet) throws IOException {
            if (beginsLine) {
                out.write(ERROR);
            }
            out.write(octet);
            beginsLine = octet == '\n';
        }
    }
}
