package org.evoloop.http;

import com.sun.net.httpserver.HttpExchange;
import java.io.IOException;
import java.io.InputStream;
import java.net.ProtocolException;
import java.net.URLDecoder;
import java.nio.ByteBuffer;
import java.nio.charset.CharacterCodingException;
import java.nio.charset.StandardCharsets;
import org.evoloop.evolution.Values;
import org.evoloop.payload.Texts;

/** The event values in a request. */
final class RequestValues {
    private static final int LONGEST_BODY = 4_096;

    private RequestValues() {}

    /** @throws IllegalArgumentException if the body is too long, or not text in UTF-8 */
    static Values of(HttpExchange exchange) throws IOException {
        Values values = Values.NONE;
        String query = exchange.getRequestURI().getRawQuery();
        for (String parameter : query == null ? new String[0] : query.split("&", -1)) {
            int sign = parameter.indexOf('=');
            if (sign > 0) {
                values = values.with(
                        decoded(parameter.substring(0, sign)), Texts.value(decoded(parameter.substring(sign + 1))));
            }
        }
        byte[] body = body(exchange);
        if (body.length > LONGEST_BODY) {
            throw new IllegalArgumentException("the body has more than " + LONGEST_BODY + " bytes");
        }
        return body.length == 0 ? values : values.with("body", text(body));
    }

    private static byte[] body(HttpExchange exchange) throws IOException {
        try {
            return exchange.getRequestBody().readNBytes(LONGEST_BODY + 1);
        } catch (RuntimeException impossible) {
            throw impossibleChunk(impossible);
        }
    }

    /** Reads what is left of a request. */
    static void skipRest(InputStream request) throws IOException {
        try {
            request.close();
        } catch (RuntimeException impossible) {
            throw impossibleChunk(impossible);
        }
    }

    /** The JDK's server does not check the lengths of chunks before it uses them. */
    private static IOException impossibleChunk(RuntimeException impossible) {
        return (IOException) new ProtocolException("the length of a chunk is impossible").initCause(impossible);
    }

    private static String decoded(String text) {
        return URLDecoder.decode(text, StandardCharsets.UTF_8);
    }

    private static String text(byte[] body) {
        try {
            return StandardCharsets.UTF_8
                    .newDecoder()
                    .decode(ByteBuffer.wrap(body))
                    .toString();
        } catch (CharacterCodingException garbage) {
            throw new IllegalArgumentException("the body is not UTF-8 text", garbage);
        }
    }
}
