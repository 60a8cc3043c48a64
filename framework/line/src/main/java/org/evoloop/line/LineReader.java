package org.evoloop.line;

import java.io.BufferedInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.nio.ByteBuffer;
import java.nio.charset.CharacterCodingException;
import java.nio.charset.StandardCharsets;
import java.util.function.Consumer;
import org.jspecify.annotations.Nullable;

/**
 * Splits bytes into lines, which end with CR, LF or both. Empty lines, lines that are not UTF-8, and lines of more than
 * {@value #LONGEST} bytes are skipped. An incomplete line at the end of the stream is ignored.
 *
 * <p>Threading: one thread reads.
 */
final class LineReader {
    static final int LONGEST = 4_096;

    private final InputStream bytes;
    private final Consumer<String> complaints;
    private final ByteArrayOutputStream line = new ByteArrayOutputStream();
    private boolean tooLong;

    /** @param complaints receives what is wrong with a skipped line */
    LineReader(InputStream bytes, Consumer<String> complaints) {
        this.bytes = new BufferedInputStream(bytes);
        this.complaints = complaints;
    }

    /** The next line, without its line end; null at the end of the stream. */
    @Nullable
    String next() throws IOException {
        for (int next = bytes.read(); next >= 0; next = bytes.read()) {
            if (next == '\n' || next == '\r') {
                String whole = take();
                if (!whole.isEmpty()) {
                    return whole;
                }
            } else if (line.size() < LONGEST) {
                line.write(next);
            } else {
                tooLong = true;
            }
        }
        return null;
    }

    private String take() {
        byte[] taken = line.toByteArray();
        line.reset();
        if (tooLong) {
            tooLong = false;
            complaints.accept("lines of more than " + LONGEST + " bytes are ignored");
            return "";
        }
        try {
            return StandardCharsets.UTF_8
                    .newDecoder()
                    .decode(ByteBuffer.wrap(taken))
                    .toString();
        } catch (CharacterCodingException garbage) {
            complaints.accept("bytes that are not UTF-8 text are ignored; check the rate of a serial port, or what is "
                    + "at the other end");
            return "";
        }
    }
}
