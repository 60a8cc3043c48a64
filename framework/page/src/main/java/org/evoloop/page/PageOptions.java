package org.evoloop.page;

import java.net.InetAddress;
import java.net.UnknownHostException;
import java.nio.file.Path;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.evoloop.config.Mistakes;
import org.evoloop.config.Option;
import org.evoloop.config.Options;
import org.evoloop.config.Settings;
import org.evoloop.page.server.ServerPlace;
import org.evoloop.page.server.TokenFile;
import org.jspecify.annotations.Nullable;

/**
 * The address of a page, and where its token is kept.
 *
 * <p>Threading: immutable.
 *
 * @param host the address to listen on, as a name or a number; empty for no page
 * @param port the port, 0 for any free one
 * @param tokenFile the file that keeps the token for the next start; null for a new token at each start
 * @since 0.1
 */
public record PageOptions(String host, int port, @Nullable Path tokenFile) {
    private static final String PAGE_OPTION = "--page";
    private static final String TOKEN_OPTION = "--page-token-file";

    private static final Option<PageOptions> PAGE = Option.value(
            "page",
            "[HOST:]PORT",
            "Shows in the browser what the converter does; only on this machine unless HOST is given, such as 0.0.0.0 "
                    + "(default: nothing listens).",
            PageOptions::at);

    private static final Option<Path> TOKEN_FILE = Option.path(
            "page-token-file",
            "FILE",
            "Keeps the page's token in this file, which only its owner may read, so that it stays the same after a "
                    + "restart (default: a new token at each start).");

    /** The options of a program. */
    public static final Options OPTIONS = Options.of(PAGE, TOKEN_FILE).checking(PageOptions::check);

    private static final String LOOPBACK = "127.0.0.1";
    private static final Pattern ADDRESS = Pattern.compile("(?:(\\[[0-9a-fA-F:.]+]|[A-Za-z0-9.-]+):)?([0-9]{1,5})");
    private static final int HIGHEST = 65_535;

    /** No page: nothing listens. */
    public static PageOptions none() {
        return new PageOptions("", 0, null);
    }

    /** The page given by a program's options. */
    public static PageOptions of(Settings settings) {
        PageOptions page = settings.get(PAGE).orElse(none());
        return new PageOptions(page.host, page.port, settings.get(TOKEN_FILE).orElse(null));
    }

    private static void check(Settings settings, Mistakes mistakes) {
        Path file = settings.get(TOKEN_FILE).orElse(null);
        if (file != null && settings.get(PAGE).isEmpty()) {
            mistakes.add("--page-token-file goes with --page; give both or neither");
        } else if (file != null) {
            mistakes.tried(
                    "page-token-file",
                    IllegalArgumentException.class::isInstance,
                    new TokenFile(TOKEN_OPTION, file)::read);
        }
        settings.get(PAGE)
                .ifPresent(
                        page -> mistakes.tried("page", IllegalArgumentException.class::isInstance, page::requireHost));
    }

    private InetAddress requireHost() {
        try {
            return InetAddress.getByName(host);
        } catch (UnknownHostException unknown) {
            throw new IllegalArgumentException(
                    "--page: there is no host " + host + "; leave it out, or use an address of this machine", unknown);
        }
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
        return new PageOptions(host == null ? LOOPBACK : host, Integer.parseInt(parts.group(2)), null);
    }

    /** Where its server listens. */
    ServerPlace place() {
        return new ServerPlace(
                PAGE_OPTION, host, port, tokenFile == null ? null : new TokenFile(TOKEN_OPTION, tokenFile));
    }

    /** Whether there is a page. */
    public boolean isOn() {
        return !host.isEmpty();
    }
}
