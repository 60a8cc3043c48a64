package org.evoloop.models.diagram;

import java.util.Locale;

/**
 * SVG text in the making, an element a line.
 *
 * <p>Threading: not thread-safe.
 */
final class Svg {
    private final StringBuilder text = new StringBuilder();

    /** An element without content; {@code attributes} are names and values in turn. */
    Svg empty(String name, Object... attributes) {
        tag(name, attributes);
        text.append("/>\n");
        return this;
    }

    /** An element with text. */
    Svg text(String name, String content, Object... attributes) {
        tag(name, attributes);
        text.append('>').append(escape(content)).append("</").append(name).append(">\n");
        return this;
    }

    Svg open(String name, Object... attributes) {
        tag(name, attributes);
        text.append(">\n");
        return this;
    }

    Svg close(String name) {
        text.append("</").append(name).append(">\n");
        return this;
    }

    /** As it is. */
    Svg raw(String svg) {
        text.append(svg);
        return this;
    }

    private void tag(String name, Object... attributes) {
        text.append('<').append(name);
        for (int i = 0; i < attributes.length; i += 2) {
            Object value = attributes[i + 1];
            String shown = value instanceof Double number ? number(number) : escape(value.toString());
            text.append(' ').append(attributes[i]).append("=\"").append(shown).append('"');
        }
    }

    /** With one decimal at most: a tenth of a pixel is enough. */
    static String number(double value) {
        String shown = String.format(Locale.ROOT, "%.1f", value);
        return shown.endsWith(".0") ? shown.substring(0, shown.length() - 2) : shown;
    }

    private static String escape(String raw) {
        return raw.replace("&", "&amp;")
                .replace("<", "&lt;")
                .replace(">", "&gt;")
                .replace("\"", "&quot;");
    }

    @Override
    public String toString() {
        return text.toString();
    }
}
