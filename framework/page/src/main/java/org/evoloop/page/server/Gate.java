package org.evoloop.page.server;

import com.sun.net.httpserver.Headers;
import com.sun.net.httpserver.HttpExchange;
import java.net.InetAddress;
import java.net.URI;
import java.net.UnknownHostException;
import java.nio.charset.StandardCharsets;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.security.SecureRandom;
import java.util.Base64;
import java.util.List;
import java.util.Locale;
import java.util.Set;
import org.jspecify.annotations.Nullable;

/**
 * Access control: who may look, and who may use the controls. Requests from other sites' pages are refused, even if a
 * name of that site leads here (DNS rebinding). The controls need the token, which is exchanged for a cookie that
 * browsers send only with this page's own requests.
 *
 * <p>Threading: thread-safe.
 *
 * @since 0.1
 */
public final class Gate {
    private static final SecureRandom RANDOM = new SecureRandom();

    private final String token;
    private final String session;
    private final String host;
    private final String cookie;
    private final Set<String> ownNames;

    /**
     * Controls access to a server.
     *
     * @param host the host name or address on which it listens
     * @param port the port on which it listens: a browser sends cookies to every port of a host
     * @param token the token for the controls; the cookie follows from it, and is as long-lived
     */
    public Gate(String host, int port, String token) {
        this.token = token;
        this.session = session(token);
        this.host = host.toLowerCase(Locale.ROOT);
        this.cookie = "evoloop-" + port;
        this.ownNames = ownNames();
    }

    /** A new token. */
    public static String secret() {
        byte[] bytes = new byte[18];
        RANDOM.nextBytes(bytes);
        return encoded(bytes);
    }

    private static String session(String token) {
        try {
            return encoded(MessageDigest.getInstance("SHA-256")
                    .digest(("session of " + token).getBytes(StandardCharsets.UTF_8)));
        } catch (NoSuchAlgorithmException impossible) {
            throw new AssertionError("every Java has SHA-256", impossible);
        }
    }

    private static String encoded(byte[] bytes) {
        return Base64.getUrlEncoder().withoutPadding().encodeToString(bytes);
    }

    private static Set<String> ownNames() {
        try {
            String name = InetAddress.getLocalHost().getHostName().toLowerCase(Locale.ROOT);
            String first = name.replaceAll("\\..*", "");
            return Set.copyOf(List.of(name, first, first + ".local"));
        } catch (UnknownHostException nameless) {
            return Set.of();
        }
    }

    /** The token for the controls. */
    public String token() {
        return token;
    }

    /** Why this request is refused; null if it is not. */
    public @Nullable String objection(HttpExchange exchange) {
        Headers headers = exchange.getRequestHeaders();
        String called = headers.getFirst("Host");
        if (called == null || !isOwn(hostOf(called))) {
            return "this page is not called " + called
                    + "; use the address that the program has printed, or this machine's name";
        }
        String site = headers.getFirst("Sec-Fetch-Site");
        boolean opened = exchange.getRequestURI().getPath().equals("/") && isReading(exchange);
        if (site != null && !site.equals("same-origin") && !site.equals("none") && !opened) {
            return "another site's page asks for this";
        }
        String origin = headers.getFirst("Origin");
        // A browser behind a TLS proxy has the page from https, at the same name.
        boolean foreign = origin != null && !origin.equals("http://" + called) && !origin.equals("https://" + called);
        return foreign || (origin == null && !isReading(exchange)) ? "another site's page asks for this" : null;
    }

    private static boolean isReading(HttpExchange exchange) {
        return exchange.getRequestMethod().matches("GET|HEAD");
    }

    private static String hostOf(String called) {
        try {
            String name = URI.create("http://" + called).getHost();
            return name == null ? "" : name.toLowerCase(Locale.ROOT);
        } catch (IllegalArgumentException nonsense) {
            return "";
        }
    }

    /** A numeric address cannot be redirected by anyone; a name can, unless it is this machine's. */
    private boolean isOwn(String name) {
        return name.matches("[0-9]+(\\.[0-9]+){3}|\\[[0-9a-f:.]+]")
                || name.equals("localhost")
                || name.equals(host)
                || ownNames.contains(name);
    }

    /** The cookie for the right token; null for any other. */
    public @Nullable String admit(String claimed) {
        return same(claimed, token) ? cookie + "=" + session + "; Path=/; HttpOnly; SameSite=Strict" : null;
    }

    /** Whether the request has the cookie. */
    public boolean isAdmitted(HttpExchange exchange) {
        String own = cookie + "=";
        for (String header : exchange.getRequestHeaders().getOrDefault("Cookie", List.of())) {
            for (String each : header.split(";", -1)) {
                if (each.strip().startsWith(own) && same(each.strip().substring(own.length()), session)) {
                    return true;
                }
            }
        }
        return false;
    }

    private static boolean same(String claimed, String secret) {
        return MessageDigest.isEqual(claimed.getBytes(StandardCharsets.UTF_8), secret.getBytes(StandardCharsets.UTF_8));
    }
}
