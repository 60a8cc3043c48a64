package org.evoloop.xmi.astah;

import java.net.URLDecoder;
import java.nio.charset.StandardCharsets;
import java.util.regex.Pattern;
import java.util.stream.Collectors;

/** Decodes names as Astah writes them. */
final class AstahNames {
    private static final Pattern CONTROL_CHARACTERS = Pattern.compile("[\\p{Cc}\\u2028\\u2029]+");

    private AstahNames() {}

    /**
     * The name as drawn. Astah writes the names of UML elements, but not of diagrams, through {@code URLEncoder}. A
     * name that cannot be decoded was written by hand and is returned unchanged.
     */
    static String decode(String written) {
        try {
            return tidy(URLDecoder.decode(written, StandardCharsets.UTF_8));
        } catch (IllegalArgumentException writtenByHand) {
            return tidy(written);
        }
    }

    /** The name on one line and stripped: a line break, with the blanks around it, becomes one space. */
    static String tidy(String name) {
        return CONTROL_CHARACTERS
                .splitAsStream(name)
                .map(String::strip)
                .filter(line -> !line.isEmpty())
                .collect(Collectors.joining(" "));
    }
}
