package org.evoloop.http;

import com.sun.net.httpserver.Headers;
import java.nio.charset.StandardCharsets;
import java.security.MessageDigest;
import java.util.regex.Pattern;
import org.jspecify.annotations.Nullable;

/**
 * Decides which requests are accepted. A browser sends the origin of a request. Pages of other sites must not operate a
 * device, even in a trusted user's browser; an address that a person types is accepted.
 *
 * <p>Threading: immutable.
 *
 * @param host to listen on
 * @param token the required token; null for none
 */
record Door(String host, @Nullable String token) {
    private static final int SHORTEST_TOKEN = 16;
    private static final String SCHEME = "Bearer ";
    private static final Pattern OWN =
            Pattern.compile("(?i)(?:localhost|[0-9]+(?:\\.[0-9]+){3}|\\[[0-9a-f:.]+])(?::[0-9]*)?");

    static Door loopback() {
        return new Door("127.0.0.1", null);
    }

    static Door guarded(String host, String token) {
        if (token.length() < SHORTEST_TOKEN) {
            throw new IllegalArgumentException("the token has " + token.length() + " characters; give it at least "
                    + SHORTEST_TOKEN + ", since other computers can reach " + host);
        }
        return new Door(host, token);
    }

    boolean isFromAPage(Headers headers) {
        String site = headers.getFirst("Sec-Fetch-Site");
        return headers.containsKey("Origin") || (site != null && !site.equals("none")) || isMisled(headers);
    }

    /**
     * Whether a name leads here that may be another site's (DNS rebinding): a browser then takes its page and this
     * server for one site, and sends neither of the headers above. A page does not know the token.
     */
    private boolean isMisled(Headers headers) {
        String called = headers.getFirst("Host");
        return token == null && called != null && !OWN.matcher(called).matches();
    }

    boolean knowsToken(Headers headers) {
        String claimed = headers.getFirst("Authorization");
        return token == null || (claimed != null && same(claimed, SCHEME + token));
    }

    private static boolean same(String claimed, String secret) {
        return MessageDigest.isEqual(claimed.getBytes(StandardCharsets.UTF_8), secret.getBytes(StandardCharsets.UTF_8));
    }
}
