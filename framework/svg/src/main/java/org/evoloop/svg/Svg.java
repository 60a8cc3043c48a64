package org.evoloop.svg;

import java.util.Locale;
import java.util.Map;

/**
 * Builds an SVG picture, one element per line. The background is white, since pages may be dark.
 *
 * <p>Threading: not thread-safe.
 *
 * @since 0.1
 */
public final class Svg {
    private final StringBuilder text = new StringBuilder();

    /**
     * Starts a picture. Lengths are in pixels.
     *
     * @param style CSS, ends in a line feed
     * @param definitions markers and the like as SVG, ends in a line feed; empty if there are none
     */
    public Svg(String title, double width, double height, double fontSize, String style, String definitions) {
        begin(title, width, height, fontSize);
        raw("<style>\n.paper { fill: #fff }\n" + style + "</style>\n");
        define(definitions);
        rectangle("paper", 0, 0, width, height, 0);
    }

    private Svg(String title, double width, double height, double fontSize, String definitions) {
        begin(title, width, height, fontSize);
        define(definitions);
    }

    /** Starts a picture without a style and a background, for a page that has them. */
    public static Svg unstyled(String title, double width, double height, double fontSize, String definitions) {
        return new Svg(title, width, height, fontSize, definitions);
    }

    private void begin(String title, double width, double height, double fontSize) {
        raw("<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 " + pair(width, height) + "\" width=\""
                + number(width) + "\" height=\"" + number(height)
                + "\" font-family=\"DejaVu Sans, Verdana, Arial, sans-serif\" font-size=\"" + number(fontSize)
                + "\">\n");
        raw("<title>" + escape(title) + "</title>\n");
    }

    private void define(String definitions) {
        raw(definitions.isEmpty() ? "" : "<defs>\n" + definitions + "</defs>\n");
    }

    /** Opens a group with these CSS classes. */
    public Svg group(String cssClass) {
        return group(cssClass, Map.of());
    }

    /** Opens a group with these CSS classes and an attribute {@code data-KEY} for each entry. */
    public Svg group(String cssClass, Map<String, String> data) {
        StringBuilder attributes = new StringBuilder();
        data.forEach((key, value) -> attributes
                .append(" data-")
                .append(key)
                .append("=\"")
                .append(escape(value))
                .append('"'));
        return raw("<g class=\"" + cssClass + "\"" + attributes + ">\n");
    }

    /** Opens a group with this CSS class, moved by {@code x} and {@code y}. */
    public Svg group(String cssClass, double x, double y) {
        return raw("<g class=\"" + cssClass + "\" transform=\"translate(" + pair(x, y) + ")\">\n");
    }

    /** Opens a group with a tooltip. */
    public Svg groupWithTip(String tip) {
        return raw("<g><title>" + escape(tip) + "</title>\n");
    }

    /** Closes the group opened last. */
    public Svg endGroup() {
        return raw("</g>\n");
    }

    /** A rectangle, its corners rounded by {@code radius}. */
    public Svg rectangle(String cssClass, double x, double y, double width, double height, double radius) {
        return raw("<rect class=\"" + cssClass + "\" x=\"" + number(x) + "\" y=\"" + number(y) + "\" width=\""
                + number(width) + "\" height=\"" + number(height) + "\" rx=\"" + number(radius) + "\"/>\n");
    }

    /** A circle with its centre at {@code x} and {@code y}. */
    public Svg circle(String cssClass, double x, double y, double radius) {
        return raw("<circle class=\"" + cssClass + "\" cx=\"" + number(x) + "\" cy=\"" + number(y) + "\" r=\""
                + number(radius) + "\"/>\n");
    }

    /** A straight line. */
    public Svg line(String cssClass, double x1, double y1, double x2, double y2) {
        return path(cssClass, "M" + pair(x1, y1) + " L" + pair(x2, y2));
    }

    /** A path with the attribute {@code d}. */
    public Svg path(String cssClass, String d) {
        return path(cssClass, d, "");
    }

    /** A path that ends with a marker; empty for none. */
    public Svg path(String cssClass, String d, String marker) {
        String end = marker.isEmpty() ? "" : " marker-end=\"" + marker + "\"";
        return raw("<path class=\"" + cssClass + "\" d=\"" + d + "\"" + end + "/>\n");
    }

    /** One line of text; {@code y} is its baseline. */
    public Svg text(String cssClass, double x, double y, String content) {
        return raw("<text class=\"" + cssClass + "\" x=\"" + number(x) + "\" y=\"" + number(y) + "\">" + escape(content)
                + "</text>\n");
    }

    private Svg raw(String svg) {
        text.append(svg);
        return this;
    }

    /** At most one decimal: a tenth of a pixel is precise enough. */
    private static String number(double value) {
        String shown = String.format(Locale.ROOT, "%.1f", value);
        return shown.endsWith(".0") ? shown.substring(0, shown.length() - 2) : shown;
    }

    /** Coordinates as in a path. */
    public static String pair(double x, double y) {
        return number(x) + " " + number(y);
    }

    private static String escape(String content) {
        return content.replace("&", "&amp;")
                .replace("<", "&lt;")
                .replace(">", "&gt;")
                .replace("\"", "&quot;");
    }

    /** The whole document. */
    @Override
    public String toString() {
        return text + "</svg>\n";
    }
}
