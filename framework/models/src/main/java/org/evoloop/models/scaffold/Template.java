package org.evoloop.models.scaffold;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** The templates of generated files, with placeholders {@code ${name}}. */
final class Template {
    private static final Pattern PLACE = Pattern.compile("\\$\\{(\\w+)}");

    private Template() {}

    /**
     * The template {@code name}, filled in.
     *
     * @throws IllegalArgumentException if a placeholder has no value
     */
    static String fill(String name, Map<String, String> values) {
        return PLACE.matcher(text(name)).replaceAll(place -> {
            String value = values.get(place.group(1));
            if (value == null) {
                throw new IllegalArgumentException("template " + name + " needs " + place.group());
            }
            return Matcher.quoteReplacement(value);
        });
    }

    /** The template {@code name}, unchanged. */
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
