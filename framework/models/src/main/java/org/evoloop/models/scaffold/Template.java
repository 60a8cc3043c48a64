package org.evoloop.models.scaffold;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** Texts that come with this program, with places to be filled in: {@code ${name}}. */
final class Template {
    private static final Pattern PLACE = Pattern.compile("\\$\\{(\\w+)}");

    private Template() {}

    /** The text {@code name}, filled in. @throws IllegalArgumentException if it has a place without a value */
    static String fill(String name, Map<String, String> values) {
        return PLACE.matcher(text(name)).replaceAll(place -> {
            String value = values.get(place.group(1));
            if (value == null) {
                throw new IllegalArgumentException("template " + name + " needs " + place.group());
            }
            return Matcher.quoteReplacement(value);
        });
    }

    /** The text {@code name} as it is. */
    static String text(String name) {
        return new String(bytes(name), StandardCharsets.UTF_8);
    }

    static byte[] bytes(String name) {
        try (InputStream bytes = Template.class.getResourceAsStream(name)) {
            if (bytes == null) {
                throw new IllegalArgumentException("there is no template " + name);
            }
            return bytes.readAllBytes();
        } catch (IOException broken) {
            throw new UncheckedIOException(broken);
        }
    }
}
