package org.evoloop.models.diagram;

import java.util.Locale;

/**
 * SVG text in the making, an element a line.
 *
 * <p>Threading: not thread-safe.
 */
final class Svg {
    private final StringBuilder text = new StringBuilder();

    /** Opens a group of these classes. */
    Svg group(String cssClass) {
        return raw("<g class=\"" + cssClass + "\">\n");
    }

    /** Opens a group of this class that is moved. */
    Svg group(String cssClass, double x, double y) {
        return raw("<g class=\"" + cssClass + "\" transform=\"translate(" + pair(x, y) + ")\">\n");
    }

    Svg endGroup() {
        return raw("</g>\n");
    }

    Svg rectangle(String cssClass, double x, double y, double width, double height, double radius) {
        return raw("<rect class=\"" + cssClass + "\" x=\"" + number(x) + "\" y=\"" + number(y) + "\" width=\""
                + number(width) + "\" height=\"" + number(height) + "\" rx=\"" + number(radius) + "\"/>\n");
    }

    Svg circle(String cssClass, double x, double y, double radius) {
        return raw("<circle class=\"" + cssClass + "\" cx=\"" + number(x) + "\" cy=\"" + number(y) + "\" r=\""
                + number(radius) + "\"/>\n");
    }

    /** Lines as in the attribute {@code d}. */
    Svg path(String cssClass, String d) {
        return raw("<path class=\"" + cssClass + "\" d=\"" + d + "\"/>\n");
    }

    /** One line of text; {@code y} is its base line. */
    Svg text(String cssClass, double x, double y, String content) {
        return raw("<text class=\"" + cssClass + "\" x=\"" + number(x) + "\" y=\"" + number(y) + "\">" + escape(content)
                + "</text>\n");
    }

    /** As it is. */
    Svg raw(String svg) {
        text.append(svg);
        return this;
    }

    /** With one decimal at most: a tenth of a pixel is enough. */
    static String number(double value) {
        String shown = String.format(Locale.ROOT, "%.1f", value);
        return shown.endsWith(".0") ? shown.substring(0, shown.length() - 2) : shown;
    }

    /** Coordinates as in a path. */
    static String pair(double x, double y) {
        return number(x) + " " + number(y);
    }

    static String escape(String content) {
        return content.replace("&", "&amp;")
                .replace("<", "&lt;")
                .replace(">", "&gt;")
                .replace("\"", "&quot;");
    }

    @Override
    public String toString() {
        return text.toString();
    }
}
