package org.evoloop.studio;

import java.io.IOException;
import java.io.InputStream;
import java.net.URI;
import java.nio.file.Path;
import java.util.List;
import org.evoloop.page.PageFiles;
import org.evoloop.page.server.PageServer;
import org.evoloop.page.server.ServerPlace;
import org.evoloop.page.server.TokenFile;
import org.evoloop.time.Clock;
import org.evoloop.time.SystemClock;
import org.jspecify.annotations.Nullable;

/**
 * Serves the studio on this machine's loopback address.
 *
 * <p>Threading: opened and closed by one thread; requests have their own.
 */
public final class Studio implements AutoCloseable {
    /** The largest request in bytes: two texts, escaped as JSON. */
    static final int LONGEST_REQUEST = 4 * Folder.LARGEST;

    private static final String LOOPBACK = "127.0.0.1";
    private static final List<String> FILES = List.of(
            "index.html",
            "studio.css",
            "studio.js",
            "change.js",
            "dom.js",
            "editor.js",
            "files.js",
            "findings.js",
            "pictures.js",
            "properties.js",
            "server.js",
            "store.js",
            "strip.js",
            "try.js");

    private final Clock clock = new SystemClock();
    private final PageServer server;

    private Studio(ServerPlace place) throws IOException {
        try {
            server = new PageServer(place, LONGEST_REQUEST, clock);
        } catch (IOException | RuntimeException refused) {
            clock.close();
            throw refused;
        }
    }

    /**
     * Serves the models of a folder until it is closed.
     *
     * @param port the port; 0 for any free one
     * @param tokenFile keeps the token for the next start; null for a new one at each start
     * @throws IOException if the folder or the port cannot be used; the message says what to do
     */
    public static Studio open(Path directory, int port, @Nullable Path tokenFile, Analysis analysis)
            throws IOException {
        Folder folder = new Folder(directory);
        TokenFile token = tokenFile == null ? null : new TokenFile("--token-file", tokenFile);
        Studio studio = new Studio(new ServerPlace("--port", LOOPBACK, port, token));
        studio.serve(new Routes(folder, analysis));
        return studio;
    }

    private void serve(Routes routes) {
        PageFiles.serve(server);
        for (String name : FILES) {
            server.file(name.equals("index.html") ? "/" : "/" + name, mediaType(name), () -> resource(name));
        }
        server.session(() -> "{}");
        server.admitted("/api/", routes::answer);
        server.start();
    }

    private static String mediaType(String name) {
        if (name.endsWith(".js")) {
            return "text/javascript; charset=utf-8";
        }
        return (name.endsWith(".css") ? "text/css" : "text/html") + "; charset=utf-8";
    }

    private static @Nullable InputStream resource(String name) {
        return Studio.class.getResourceAsStream(name);
    }

    /** The address for this machine's browser, with the token. */
    public URI address() {
        return URI.create("http://" + LOOPBACK + ":" + server.port() + "/#token="
                + server.gate().token());
    }

    /** Ends it. Idempotent. */
    @Override
    public void close() {
        server.close();
        clock.close();
    }
}
