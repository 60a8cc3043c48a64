package org.evoloop.page;

import org.evoloop.page.server.PageServer;

/**
 * What the page shares with other pages of this program, so that they look and behave alike.
 *
 * <p>Threading: pure functions, which any thread may call.
 *
 * @since 0.1
 */
public final class PageFiles {
    private PageFiles() {}

    /** Serves the style, the drawing and the icon, at {@code /style.css}, {@code /drawing.js} and {@code /icon.svg}. */
    public static void serve(PageServer server) {
        server.file("/style.css", "text/css; charset=utf-8", () -> PageFiles.class.getResourceAsStream("style.css"));
        server.file(
                "/drawing.js",
                "text/javascript; charset=utf-8",
                () -> PageFiles.class.getResourceAsStream("drawing.js"));
        server.file("/icon.svg", "image/svg+xml", () -> PageFiles.class.getResourceAsStream("icon.svg"));
    }
}
