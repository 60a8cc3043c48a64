package org.evoloop.page;

import com.sun.net.httpserver.Headers;
import com.sun.net.httpserver.HttpExchange;
import java.net.InetAddress;
import java.net.URI;
import java.net.UnknownHostException;
import java.nio.charset.StandardCharsets;
import java.security.MessageDigest;
import java.security.SecureRandom;
import java.util.Base64;
import java.util.List;
import java.util.Locale;
import java.util.Set;
import org.jspecify.annotations.Nullable;

/**
 * Who may look, and who may do something. A browser that was sent here by another site's page is turned away, also if a
 * name of that site leads here (DNS rebinding); whoever wants to do something needs the token, for which a cookie is
 * given that browsers send with this page's own requests alone.
 *
 * <p>Threading: thread-safe.
 */
final class Gate {
    private static final SecureRandom RANDOM = new SecureRandom();

    private final String token = secret();
    private final String session = secret();
    private final String host;
    private final String cookie;
    private final Set<String> ownNames;

    /**
     * @param host under which it was told to listen
     * @param port on which it listens: a browser sends cookies to every port of a host
     */
    Gate(String host, int port) {
        this.host = host.toLowerCase(Locale.ROOT);
        this.cookie = "evoloop-" + port;
        this.ownNames = ownNames();
    }

    private static String secret() {
        byte[] bytes = new byte[18];
        RANDOM.nextBytes(bytes);
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

    /** What must be known to do something. */
    String token() {
        return token;
    }

    /** Why this request is turned away; null if it is not. */
    @Nullable
    String objection(HttpExchange exchange) {
        Headers headers = exchange.getRequestHeaders();
        String called = headers.getFirst("Host");
        if (called == null || !isOwn(hostOf(called))) {
            return "this page is not called " + called
                    + "; use its address as a number, this machine's name, or the name after --page";
        }
        String site = headers.getFirst("Sec-Fetch-Site");
        boolean opened = exchange.getRequestURI().getPath().equals("/") && isGet(exchange);
        if (site != null && !site.equals("same-origin") && !site.equals("none") && !opened) {
            return "another site's page asks for this";
        }
        String origin = headers.getFirst("Origin");
        boolean foreign = origin != null && !origin.equals("http://" + called);
        return foreign || (origin == null && !isGet(exchange)) ? "another site's page asks for this" : null;
    }

    private static boolean isGet(HttpExchange exchange) {
        return exchange.getRequestMethod().equals("GET");
    }

    private static String hostOf(String called) {
        try {
            String name = URI.create("http://" + called).getHost();
            return name == null ? "" : name.toLowerCase(Locale.ROOT);
        } catch (IllegalArgumentException nonsense) {
            return "";
        }
    }

    /** A number is nobody's to have lead elsewhere; a name is, unless it is this machine's. */
    private boolean isOwn(String name) {
        return name.matches("[0-9]+(\\.[0-9]+){3}|\\[[0-9a-f:.]+]")
                || name.equals("localhost")
                || name.equals(host)
                || ownNames.contains(name);
    }

    /** The cookie for whoever knows the token; null for anybody else. */
    @Nullable
    String admit(String claimed) {
        return same(claimed, token) ? cookie + "=" + session + "; Path=/; HttpOnly; SameSite=Strict" : null;
    }

    /** Whether whoever asks has shown the token. */
    boolean isAdmitted(HttpExchange exchange) {
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
