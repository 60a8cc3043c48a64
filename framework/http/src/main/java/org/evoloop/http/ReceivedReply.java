package org.evoloop.http;

import java.io.BufferedInputStream;
import java.io.ByteArrayOutputStream;
import java.io.EOFException;
import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.util.Locale;

/**
 * An answer (RFC 9112). At most {@value #LONGEST_BODY} bytes of its body are read, and only on request.
 *
 * <p>Threading: for one thread.
 *
 * @param length of the body; {@link #CHUNKED} or {@link #TO_THE_END} if it is not given
 */
record ReceivedReply(int status, long length, InputStream rest) {
    static final int LONGEST_BODY = 65_536;

    private static final int LONGEST_LINE = 8_192;
    private static final int MOST_HEADERS = 200;
    private static final int FINAL = 200;
    private static final long CHUNKED = -1;
    private static final long TO_THE_END = -2;

    static ReceivedReply read(InputStream stream) throws IOException {
        InputStream bytes = new BufferedInputStream(stream);
        ReceivedReply reply = head(bytes);
        while (reply.status() < FINAL) {
            reply = head(bytes);
        }
        return reply;
    }

    private static ReceivedReply head(InputStream bytes) throws IOException {
        String first = line(bytes);
        if (!first.matches("HTTP/1\\.[01] [1-5][0-9]{2}.*")) {
            throw new IOException("the answer is not HTTP");
        }
        long length = TO_THE_END;
        int headers = 0;
        for (String line = line(bytes); !line.isEmpty(); line = line(bytes)) {
            String header = line.toLowerCase(Locale.ROOT).replaceAll("\\s", "");
            if (++headers > MOST_HEADERS) {
                throw new IOException("the answer has too many headers");
            }
            if (header.startsWith("transfer-encoding:") && header.endsWith("chunked")) {
                length = CHUNKED;
            } else if (header.matches("content-length:[0-9]{1,15}") && length != CHUNKED) {
                length = Long.parseLong(header.substring("content-length:".length()));
            }
        }
        return new ReceivedReply(Integer.parseInt(first.substring(9, 12)), length, bytes);
    }

    private static String line(InputStream bytes) throws IOException {
        ByteArrayOutputStream line = new ByteArrayOutputStream();
        for (int next = bytes.read(); next != '\n'; next = bytes.read()) {
            if (next < 0 || line.size() > LONGEST_LINE) {
                throw new EOFException("the answer ends, or has no end, in the middle of its headers");
            }
            line.write(next);
        }
        return line.toString(StandardCharsets.ISO_8859_1).stripTrailing();
    }

    /**
     * The body, or its beginning, as text in UTF-8.
     *
     * @throws IOException if it is cut short
     */
    String body() throws IOException {
        if (length != CHUNKED) {
            byte[] body = rest.readNBytes((int) Math.min(LONGEST_BODY, length < 0 ? LONGEST_BODY : length));
            requireWhole(length < 0 || body.length == Math.min(length, LONGEST_BODY));
            return new String(body, StandardCharsets.UTF_8);
        }
        ByteArrayOutputStream body = new ByteArrayOutputStream();
        while (body.size() < LONGEST_BODY) {
            int size = chunk();
            if (size == 0) {
                break;
            }
            byte[] part = rest.readNBytes(Math.min(size, LONGEST_BODY - body.size()));
            body.writeBytes(part);
            requireWhole(part.length == size || body.size() == LONGEST_BODY);
            if (body.size() < LONGEST_BODY) {
                line(rest);
            }
        }
        return body.toString(StandardCharsets.UTF_8);
    }

    private int chunk() throws IOException {
        String size = line(rest).replaceFirst(";.*", "").strip();
        requireWhole(size.matches("[0-9a-fA-F]{1,7}"));
        return Integer.parseInt(size, 16);
    }

    private static void requireWhole(boolean whole) throws EOFException {
        if (!whole) {
            throw new EOFException("the answer's body is cut short");
        }
    }
}
