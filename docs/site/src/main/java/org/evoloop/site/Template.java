package org.evoloop.site;

import java.util.Map;
import java.util.stream.Collectors;

/** The frame of a page. */
final class Template {
    private static final String WHOLE = """
            <!DOCTYPE html>
            <html lang="en">
            <head>
            <meta charset="utf-8">
            <meta name="viewport" content="width=device-width, initial-scale=1">
            <title>%1$s</title>
            <link rel="stylesheet" href="%2$s">
            </head>
            <body>
            <nav>
            <a href="%3$sindex.html">Evoloop</a>
            <a href="%3$sdocs/index.html">Documentation</a>
            <a href="%3$s%4$s">API</a>
            <a href="%3$sCONTRIBUTING.html">Contributing</a>
            <a href="%3$sCHANGELOG.html">Changes</a>
            </nav>
            %5$s<main>
            %6$s</main>
            </body>
            </html>
            """;

    private Template() {}

    /** @param home the way from the page's folder to the site's, empty or with a slash at its end */
    static String of(Page page, String home, String style) {
        String title = page.title().equals("Evoloop") ? "Evoloop" : page.title() + " - Evoloop";
        return WHOLE.formatted(escaped(title), style, home, Site.API, contents(page.sections()), page.body());
    }

    private static String contents(Map<String, String> sections) {
        return sections.size() < 3
                ? ""
                : sections.entrySet().stream()
                        .map(section ->
                                "<a href=\"#%s\">%s</a>%n".formatted(section.getKey(), escaped(section.getValue())))
                        .collect(Collectors.joining("", "<aside>\n", "</aside>\n"));
    }

    private static String escaped(String text) {
        return text.replace("&", "&amp;").replace("<", "&lt;").replace(">", "&gt;");
    }
}
