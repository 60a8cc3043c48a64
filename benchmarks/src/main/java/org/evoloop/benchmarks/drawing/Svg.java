package org.evoloop.benchmarks.drawing;

import java.util.Locale;

/**
 * An SVG picture in the making, an element a line, on white paper: pages may be dark.
 *
 * <p>Threading: not thread-safe.
 */
final class Svg {
    private final StringBuilder text = new StringBuilder();

    Svg(String title, double width, double height, String style) {
        text.append(String.format(
                Locale.ROOT,
                "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 %1$.0f %2$.0f\" width=\"%1$.0f\""
                        + " height=\"%2$.0f\" font-family=\"DejaVu Sans, Verdana, Arial, sans-serif\">\n",
                width,
                height));
        text.append("<title>").append(escape(title)).append("</title>\n");
        text.append("<style>\n.paper { fill: #fff }\n").append(style).append("</style>\n");
        rectangle("paper", 0, 0, width, height);
    }

    Svg rectangle(String cssClass, double x, double y, double width, double height) {
        return add(
                "<rect class=\"%s\" x=\"%.1f\" y=\"%.1f\" width=\"%.1f\" height=\"%.1f\"/>",
                cssClass, x, y, width, height);
    }

    Svg circle(String cssClass, double x, double y, double radius) {
        return add("<circle class=\"%s\" cx=\"%.1f\" cy=\"%.1f\" r=\"%.1f\"/>", cssClass, x, y, radius);
    }

    Svg line(String cssClass, double x1, double y1, double x2, double y2) {
        return add("<path class=\"%s\" d=\"M%.1f %.1f L%.1f %.1f\"/>", cssClass, x1, y1, x2, y2);
    }

    /** One line of text; {@code y} is its base line. */
    Svg text(String cssClass, double x, double y, String content) {
        return add("<text class=\"%s\" x=\"%.1f\" y=\"%.1f\">%s</text>", cssClass, x, y, escape(content));
    }

    /** Opens a group that tells this to whoever points at it. */
    Svg group(String tip) {
        return add("<g><title>%s</title>", escape(tip));
    }

    Svg endGroup() {
        return add("</g>");
    }

    private Svg add(String format, Object... values) {
        text.append(String.format(Locale.ROOT, format, values)).append('\n');
        return this;
    }

    private static String escape(String content) {
        return content.replace("&", "&amp;").replace("<", "&lt;").replace(">", "&gt;");
    }

    @Override
    public String toString() {
        return text + "</svg>\n";
    }
}
