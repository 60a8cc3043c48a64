package org.evoloop.http;

import java.io.IOException;
import java.net.URI;
import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.util.Locale;
import java.util.Map;
import java.util.TreeMap;
import org.evoloop.evolution.Values;
import org.evoloop.payload.Template;

/**
 * A request to a device. The address of {@link #get}, {@link #post} and {@link #put}, and the body, may contain values
 * of the event, as in {@code http://fan.local/speed/${speed}}; see {@link Template}.
 *
 * <p>Threading: immutable.
 *
 * @param method such as {@code POST}
 * @param address with {@code http://} or {@code https://}
 * @param headers by name
 * @param body as text in UTF-8; empty for none
 * @param repeatable whether the device may receive it twice without harm, such as "on" but not "toggle"
 * @param lowest the lowest status by which the device says that it has obeyed
 * @param highest the highest such status
 * @since 0.1
 */
public record HttpCall(
        String method,
        URI address,
        Map<String, String> headers,
        String body,
        boolean repeatable,
        int lowest,
        int highest) {
    private static final int LOWEST = 200;
    private static final int HIGHEST = 299;
    private static final String OWN_HEADERS = "(?i)host|connection|content-length|transfer-encoding|expect|upgrade";

    /** @throws IllegalArgumentException if the address is not an HTTP address, a header cannot be sent, or no status is accepted */
    public HttpCall {
        headers = Map.copyOf(headers);
        String scheme = address.getScheme() == null ? "" : address.getScheme().toLowerCase(Locale.ROOT);
        if (!scheme.matches("https?") || address.getHost() == null) {
            throw new IllegalArgumentException(
                    "'" + address + "' is not an address; write one such as http://lamp.local/toggle");
        }
        if (!method.matches("[A-Z]+")) {
            throw new IllegalArgumentException("'" + method + "' is not a method; write one such as POST");
        }
        if (lowest < LOWEST || highest < lowest || highest > 599) {
            throw new IllegalArgumentException(
                    "no answer has a status from " + lowest + " to " + highest + "; there are 200 to 599");
        }
        headers.forEach((name, value) -> {
            if (!name.matches("[A-Za-z0-9-]+") || name.matches(OWN_HEADERS) || !value.matches("[\\x20-\\x7e]*")) {
                throw new IllegalArgumentException("the header " + name + " cannot be sent");
            }
        });
    }

    /** A URI cannot contain the braces of places for values, so they are escaped. */
    private static URI uri(String address) {
        return URI.create(address.replace("{", "%7B").replace("}", "%7D"));
    }

    /**
     * A copy with an event's values in their places.
     *
     * @throws IllegalArgumentException if one is missing
     */
    HttpCall with(Values values) {
        String places = address.toString().replace("%7B", "{").replace("%7D", "}");
        return new HttpCall(
                method,
                uri(Template.url(places).with(values)),
                headers,
                Template.of(body).with(values),
                repeatable,
                lowest,
                highest);
    }

    /** A GET, which many devices accept as a command. */
    public static HttpCall get(String address) {
        return new HttpCall("GET", uri(address), Map.of(), "", false, LOWEST, HIGHEST);
    }

    /** A POST with this body. */
    public static HttpCall post(String address, String body) {
        return new HttpCall("POST", uri(address), Map.of(), body, false, LOWEST, HIGHEST);
    }

    /** A PUT with this body. */
    public static HttpCall put(String address, String body) {
        return new HttpCall("PUT", uri(address), Map.of(), body, false, LOWEST, HIGHEST);
    }

    /** A copy with another header, such as {@code Content-Type} or {@code Authorization}. */
    public HttpCall header(String name, String value) {
        Map<String, String> more = new TreeMap<>(headers);
        more.put(name, value);
        return new HttpCall(method, address, more, body, repeatable, lowest, highest);
    }

    /** A copy that the device may receive twice without harm, so that it is repeated if it is not answered. */
    public HttpCall canBeRepeated() {
        return new HttpCall(method, address, headers, body, true, lowest, highest);
    }

    /** A copy that was obeyed if the answer's status is in this range, instead of 200 to 299. */
    public HttpCall accepting(int from, int to) {
        return new HttpCall(method, address, headers, body, repeatable, from, to);
    }

    boolean accepts(int status) {
        return status >= lowest && status <= highest;
    }

    /**
     * Sends it, and waits for the answer.
     *
     * @param values for the places in address and body
     * @param limit the time limit for the answer
     * @throws IOException if there is none, or its status is not accepted
     * @throws IllegalArgumentException if a value is missing
     */
    public void send(Values values, Duration limit) throws IOException, InterruptedException {
        new Caller(limit).call(with(values), reply -> "");
    }

    boolean isSecure() {
        return address.getScheme().equalsIgnoreCase("https");
    }

    int port() {
        return address.getPort() > 0 ? address.getPort() : isSecure() ? 443 : 80;
    }

    /** The bytes that are sent (RFC 9112). */
    byte[] bytes() {
        String path = address.getRawPath().isEmpty() ? "/" : address.getRawPath();
        String query = address.getRawQuery() == null ? "" : "?" + address.getRawQuery();
        String host = address.getHost() + (address.getPort() > 0 ? ":" + address.getPort() : "");
        StringBuilder text = new StringBuilder(method + " " + path + query + " HTTP/1.1\r\nHost: " + host + "\r\n");
        headers.forEach(
                (name, value) -> text.append(name).append(": ").append(value).append("\r\n"));
        if (!body.isEmpty() || !method.equals("GET")) {
            int length = body.getBytes(StandardCharsets.UTF_8).length;
            text.append("Content-Length: ").append(length).append("\r\n");
        }
        return (text + "Connection: close\r\n\r\n" + body).getBytes(StandardCharsets.UTF_8);
    }

    /** Where it goes: {@code http://lamp.local}. */
    String device() {
        return address.getScheme() + "://" + address.getHost() + (address.getPort() > 0 ? ":" + address.getPort() : "");
    }

    /** For messages: {@code POST http://lamp.local/toggle}, without parts that may be secret. */
    @Override
    public String toString() {
        return method + " " + device() + address.getPath();
    }
}
