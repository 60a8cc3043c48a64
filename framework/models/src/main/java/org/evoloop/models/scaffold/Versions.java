package org.evoloop.models.scaffold;

import java.io.IOException;
import java.io.StringReader;
import java.io.UncheckedIOException;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Properties;

/** The versions that this program was built with; a generated project uses the same. */
final class Versions {
    private static final Map<String, String> ALL = read();

    private Versions() {}

    private static Map<String, String> read() {
        Properties properties = new Properties();
        try {
            properties.load(new StringReader(Template.text("versions.properties")));
        } catch (IOException broken) {
            throw new UncheckedIOException(broken);
        }
        Map<String, String> versions = new LinkedHashMap<>();
        properties.stringPropertyNames().forEach(name -> versions.put(name, properties.getProperty(name)));
        return versions;
    }

    /** By their names in the file {@code versions.properties}. */
    static Map<String, String> all() {
        return new LinkedHashMap<>(ALL);
    }
}
