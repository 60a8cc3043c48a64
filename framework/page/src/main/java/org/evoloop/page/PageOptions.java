package org.evoloop.page;

import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.evoloop.config.Option;
import org.evoloop.config.Options;
import org.evoloop.config.Settings;

/**
 * The address of a page.
 *
 * <p>Threading: immutable.
 *
 * @param host the address to listen on, as a name or a number; empty for no page
 * @param port the port, 0 for any free one
 * @since 0.1
 */
public record PageOptions(String host, int port) {
    private static final Option<PageOptions> PAGE = Option.value(
            "page",
            "[HOST:]PORT",
            "Shows in the browser what the converter does; only on this machine unless HOST is given, such as 0.0.0.0 "
                    + "(default: nothing listens).",
            PageOptions::at);

    /** The option of a program. */
    public static final Options OPTIONS = Options.of(PAGE);

    private static final String LOOPBACK = "127.0.0.1";
    private static final Pattern ADDRESS = Pattern.compile("(?:(\\[[0-9a-fA-F:.]+]|[A-Za-z0-9.-]+):)?([0-9]{1,5})");
    private static final int HIGHEST = 65_535;

    /** No page: nothing listens. */
    public static PageOptions none() {
        return new PageOptions("", 0);
    }

    /** The page given by a program's options. */
    public static PageOptions of(Settings settings) {
        return settings.get(PAGE).orElse(none());
    }

    /**
     * A page at this address.
     *
     * @param address {@code PORT}, for this machine only, or {@code HOST:PORT}, with an IPv6 address in brackets
     * @throws IllegalArgumentException if it is neither
     */
    public static PageOptions at(String address) {
        Matcher parts = ADDRESS.matcher(address);
        if (!parts.matches() || Integer.parseInt(parts.group(2)) > HIGHEST) {
            throw new IllegalArgumentException("--page takes a port, 0 to " + HIGHEST
                    + ", and before it a host if others than this machine shall see it, as in 8080 or 192.168.1.5:8080;"
                    + " not '" + address + "'");
        }
        String host = parts.group(1);
        return new PageOptions(host == null ? LOOPBACK : host, Integer.parseInt(parts.group(2)));
    }

    /** Whether there is a page. */
    public boolean isOn() {
        return !host.isEmpty();
    }
}
