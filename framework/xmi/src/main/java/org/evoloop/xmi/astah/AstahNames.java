package org.evoloop.xmi.astah;

import java.net.URLDecoder;
import java.nio.charset.StandardCharsets;
import java.util.regex.Pattern;
import java.util.stream.Collectors;

/** How Astah writes names. */
final class AstahNames {
    private static final Pattern CONTROL_CHARACTERS = Pattern.compile("[\\p{Cc}\\u2028\\u2029]+");

    private AstahNames() {}

    /**
     * The name as it was drawn: Astah writes the names of UML elements, not of diagrams, through {@code URLEncoder}.
     * What cannot be decoded was written by hand and stays.
     */
    static String decode(String written) {
        try {
            return tidy(URLDecoder.decode(written, StandardCharsets.UTF_8));
        } catch (IllegalArgumentException writtenByHand) {
            return tidy(written);
        }
    }

    /** One line without blanks around it: a line break, with the blanks around it, becomes one space. */
    static String tidy(String name) {
        return CONTROL_CHARACTERS
                .splitAsStream(name)
                .map(String::strip)
                .filter(line -> !line.isEmpty())
                .collect(Collectors.joining(" "));
    }
}
