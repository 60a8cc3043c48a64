package org.evoloop.homeassistant;

import java.net.URI;
import java.net.URISyntaxException;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.Map;
import java.util.function.UnaryOperator;
import javax.net.ssl.TrustManagerFactory;
import org.evoloop.config.Trust;
import org.jspecify.annotations.Nullable;

/**
 * The address of a Home Assistant, as a browser shows it: {@code http://HOST[:PORT]}, whose port is 8123 if none is given,
 * or {@code https://HOST[:PORT]}. With TLS, after a question mark:
 *
 * <ul>
 *   <li>{@code ca=FILE}: the certificates, in PEM, that signed its own (default: those that Java trusts)
 *   <li>{@code sha256=FINGERPRINT}: its own certificate, such as one that it signed itself; no other is trusted
 * </ul>
 *
 * <p>Threading: immutable. Its text contains no secret.
 *
 * @since 0.1
 */
public final class HomeAddress {
    private static final String EXAMPLE = "give it as http://homeassistant.local:8123 or https://HOST";
    private static final int USUAL_PORT = 8123;

    private final URI place;
    private final @Nullable TrustManagerFactory trust;

    private HomeAddress(URI place, @Nullable TrustManagerFactory trust) {
        this.place = place;
        this.trust = trust;
    }

    /**
     * Reads an address.
     *
     * @throws IllegalArgumentException if it is invalid, or names a file that cannot be read; the message says what is
     *     wrong
     */
    public static HomeAddress parse(String url) {
        return parse(url, file -> file);
    }

    /** As {@link #parse(String)}, where {@code files} finds the file of {@code ca}. */
    public static HomeAddress parse(String url, UnaryOperator<Path> files) {
        URI uri;
        try {
            uri = new URI(url);
        } catch (URISyntaxException malformed) {
            throw new IllegalArgumentException(
                    "Home Assistant's URL cannot be read: " + malformed.getReason() + "; " + EXAMPLE);
        }
        if (uri.getRawUserInfo() != null) {
            throw new IllegalArgumentException(
                    "Home Assistant's URL contains a login, which it does not take; leave out "
                            + "what is before the @, and put a long-lived access token into a file (token-file) or into the environment");
        }
        boolean secure = "https".equals(uri.getScheme());
        if (!(secure || "http".equals(uri.getScheme()))
                || uri.getHost() == null
                || uri.getPort() == 0
                || uri.getPort() > 65_535
                || uri.getFragment() != null
                || !uri.getPath().matches("/?")) {
            throw new IllegalArgumentException(
                    "'" + url.replaceFirst("[?].*", "") + "' is no address of a Home Assistant; " + EXAMPLE);
        }
        Map<String, String> parameters = parameters(uri, secure);
        String file = parameters.get("ca");
        String pinned = parameters.get("sha256");
        int port = uri.getPort() >= 0 ? uri.getPort() : secure ? -1 : USUAL_PORT;
        return new HomeAddress(
                URI.create(uri.getScheme() + "://" + uri.getHost() + (port < 0 ? "" : ":" + port)),
                file != null ? Trust.in(files.apply(Path.of(file))) : pinned != null ? Trust.pinned(pinned) : null);
    }

    private static Map<String, String> parameters(URI uri, boolean secure) {
        Map<String, String> found = new HashMap<>();
        for (String each :
                uri.getQuery() == null ? new String[0] : uri.getQuery().split("&")) {
            String[] parts = each.split("=", 2);
            if (!parts[0].matches("ca|sha256") || parts.length < 2 || parts[1].isEmpty()) {
                throw new IllegalArgumentException("Home Assistant's URL has '" + parts[0]
                        + "' after its question mark; there are ca=FILE and sha256=FINGERPRINT");
            }
            found.put(parts[0], parts[1]);
        }
        if (found.size() > 1) {
            throw new IllegalArgumentException(
                    "Home Assistant's URL has both ca and sha256; give the certificates that "
                            + "signed its own, or its fingerprint");
        }
        if (!found.isEmpty() && !secure) {
            throw new IllegalArgumentException(
                    "Home Assistant's URL names certificates, but http:// uses none; begin it with https://");
        }
        return found;
    }

    /** Where its WebSocket API is. */
    URI webSocket() {
        return URI.create(place.toString().replaceFirst("^http", "ws") + "/api/websocket");
    }

    /** What is trusted; null for the certificates that Java trusts. */
    @Nullable
    TrustManagerFactory trust() {
        return trust;
    }

    /** For messages: {@code http://homeassistant.local:8123}. */
    @Override
    public String toString() {
        return place.toString();
    }
}
