package org.evoloop.mqtt;

import java.net.URI;
import java.net.URISyntaxException;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Set;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import javax.net.ssl.TrustManagerFactory;
import org.evoloop.config.Trust;
import org.jspecify.annotations.Nullable;

/**
 * The address of a broker and the login: {@code mqtt://[USER@]HOST[:PORT]}, or {@code mqtts://} with TLS. After a
 * question mark follow, separated by {@code &}:
 *
 * <ul>
 *   <li>{@code id=ID}: the converter's name at the broker (default: its name)
 *   <li>{@code ca=FILE}: with TLS, the certificates, in PEM, that signed the broker's (default: those that Java trusts)
 *   <li>{@code sha256=FINGERPRINT}: with TLS, the broker's own certificate, such as one that it signed itself; no other
 *       is trusted. With {@code sha256=ask} none is, and the message about it shows the fingerprint, to be confirmed
 *   <li>{@code discovery=PREFIX}: where Home Assistant looks for devices (default: {@code homeassistant})
 * </ul>
 *
 * <p>Threading: immutable. Its text contains no password.
 *
 * @since 0.1
 */
public final class BrokerAddress {
    private static final Set<String> PARAMETERS = Set.of("id", "ca", "sha256", "discovery");
    private static final String EXAMPLE = "give it as mqtt://HOST, mqtt://USER@HOST:1883 or mqtts://USER@HOST";

    private final boolean tls;
    private final String host;
    private final int port;
    private final @Nullable String user;
    private final @Nullable String password;
    private final @Nullable TrustManagerFactory trust;
    private final Map<String, String> parameters;

    /** A URL's part between the slashes; without a port it is -1. */
    private record Place(@Nullable String user, String host, int port) {
        private static final Pattern WITH_UNDERSCORE =
                Pattern.compile("(?:(.*)@)?([A-Za-z0-9.-]*_[A-Za-z0-9._-]*)(?::([0-9]{1,5}))?");

        /** Null if there is none. A {@link URI} does not know a host with an underscore, as Docker gives it. */
        static @Nullable Place in(URI uri) {
            if (uri.getHost() != null) {
                return new Place(uri.getUserInfo(), uri.getHost(), uri.getPort());
            }
            Matcher parts = WITH_UNDERSCORE.matcher(uri.getAuthority() == null ? "" : uri.getAuthority());
            return parts.matches()
                    ? new Place(
                            parts.group(1),
                            parts.group(2),
                            parts.group(3) == null ? -1 : Integer.parseInt(parts.group(3)))
                    : null;
        }
    }

    private BrokerAddress(
            boolean tls,
            Place place,
            Map<String, String> parameters,
            @Nullable TrustManagerFactory trust,
            @Nullable String password) {
        this.tls = tls;
        this.host = place.host();
        this.port = place.port() >= 0 ? place.port() : tls ? 8883 : 1883;
        this.user = place.user();
        this.parameters = parameters;
        this.trust = trust;
        this.password = password;
    }

    /**
     * Reads an address.
     *
     * @throws IllegalArgumentException if it is invalid, or names a file that cannot be read; the message says what is
     *     wrong and shows no password
     */
    public static BrokerAddress parse(String url) {
        URI uri;
        try {
            uri = new URI(url);
        } catch (URISyntaxException malformed) {
            throw new IllegalArgumentException(
                    "the broker's URL " + masked(url) + " cannot be read: " + malformed.getReason() + "; " + EXAMPLE);
        }
        String path = uri.getPath();
        Place place = Place.in(uri);
        if (!("mqtt".equals(uri.getScheme()) || "mqtts".equals(uri.getScheme()))
                || place == null
                || place.port() == 0
                || place.port() > 65_535
                || uri.getFragment() != null
                || !(path == null || path.isEmpty() || path.equals("/"))) {
            throw new IllegalArgumentException("the broker's URL " + masked(url) + " names no broker; " + EXAMPLE);
        }
        String user = place.user();
        if (user != null && user.contains(":")) {
            throw new IllegalArgumentException("the broker's URL " + masked(url)
                    + " contains a password, which everybody on this computer can see; leave it out, and put it into a file, "
                    + "with --mqtt-password-file FILE (password-file: FILE at a device file's connection), or into the environment as "
                    + MqttOptions.PASSWORD.variable());
        }
        Map<String, String> parameters = parameters(uri);
        String certificates = parameters.get("ca");
        // Read once, and kept with the address: the file may be a pipe.
        String pinned = parameters.get("sha256");
        TrustManagerFactory trust =
                certificates != null ? Trust.in(Path.of(certificates)) : pinned != null ? Trust.pinned(pinned) : null;
        return new BrokerAddress("mqtts".equals(uri.getScheme()), place, parameters, trust, null);
    }

    /**
     * A copy with the user's password.
     *
     * @throws IllegalArgumentException if the address has no user
     */
    public BrokerAddress withPassword(String secret) {
        if (user == null) {
            throw new IllegalArgumentException("the broker's URL " + this
                    + " names no user whose password this could be; write the user before the host: mqtt://USER@HOST");
        }
        return new BrokerAddress(tls, new Place(user, host, port), parameters, trust, secret);
    }

    private static Map<String, String> parameters(URI uri) {
        Map<String, String> found = new LinkedHashMap<>();
        String query = uri.getQuery();
        for (String each : query == null ? new String[0] : query.split("&")) {
            String[] parts = each.split("=", 2);
            if (!PARAMETERS.contains(parts[0]) || parts.length < 2 || parts[1].isEmpty()) {
                throw new IllegalArgumentException(
                        "the broker's URL " + masked(uri.toString()) + " has '" + parts[0]
                                + "' after its question mark; there are id=ID, ca=FILE, sha256=FINGERPRINT and discovery=PREFIX");
            }
            found.put(parts[0], parts[1]);
        }
        requireMatch(found.get("id"), "id", "[A-Za-z0-9_-]{1,64}", "letters, digits, _ and -, 64 at most");
        requireMatch(found.get("discovery"), "discovery", "[^#+\\p{Cntrl}]{1,100}", "a topic, without # and +");
        if (found.containsKey("ca") && found.containsKey("sha256")) {
            throw new IllegalArgumentException("the broker's URL " + masked(uri.toString())
                    + " has both ca and sha256; give the certificates that signed the broker's, or its fingerprint");
        }
        if ((found.containsKey("ca") || found.containsKey("sha256")) && !"mqtts".equals(uri.getScheme())) {
            throw new IllegalArgumentException("the broker's URL " + masked(uri.toString())
                    + " names certificates, but mqtt:// uses none; begin it with mqtts://");
        }
        return found;
    }

    private static void requireMatch(@Nullable String value, String name, String pattern, String allowed) {
        if (value != null && !value.matches(pattern)) {
            throw new IllegalArgumentException(
                    "the broker's URL has " + name + "=" + value + "; allowed are " + allowed);
        }
    }

    /**
     * The text without anything that may be a password: what is between the first colon, however it is written, and the
     * last {@code @}, and the values of unknown parameters.
     */
    private static String masked(String url) {
        return url.replaceFirst("^((?:[A-Za-z]+:/+|mqtts?:)?+.*?)(:|%3[Aa]).*@", "$1$2***@")
                .replaceAll("([?&](?!(?:id|ca|sha256|discovery)=)[^=&@]*=)[^&@]*", "$1***");
    }

    boolean tls() {
        return tls;
    }

    String host() {
        return host;
    }

    int port() {
        return port;
    }

    @Nullable
    String user() {
        return user;
    }

    @Nullable
    String password() {
        return password;
    }

    /** What is trusted; null for the certificates that Java trusts. */
    @Nullable
    TrustManagerFactory trust() {
        return trust;
    }

    /** The name at the broker of the converter with this name: from the address, else the same. */
    public String id(String converter) {
        String id = parameters.get("id");
        return id == null ? converter.replaceAll("[^A-Za-z0-9_-]", "_") : id;
    }

    /** The prefix of the topics where Home Assistant looks for devices. */
    public String discovery() {
        return parameters.getOrDefault("discovery", "homeassistant");
    }

    /** For messages: {@code mqtts://ha@broker:8883}. */
    @Override
    public String toString() {
        return (tls ? "mqtts://" : "mqtt://") + (user == null ? "" : user + "@") + host + ":" + port;
    }
}
