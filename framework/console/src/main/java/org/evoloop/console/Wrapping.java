package org.evoloop.console;

import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * Wraps long lines between words. Continuation lines are indented to where the line's text begins, that is, after a
 * label and two or more blanks, as in {@code states      original Off}, but at most to half of the width.
 */
final class Wrapping {
    /** The default width of text for people. */
    static final int USUAL_WIDTH = 80;

    private static final Pattern LABEL = Pattern.compile("^ *\\S+( \\S+)*? {2,}(?=\\S)");

    private Wrapping() {}

    /**
     * Wraps text at {@code width} characters. A longer word has a line of its own; JSON, which is for programs, is
     * unchanged.
     */
    static String wrap(String text, int width) {
        StringBuilder wrapped = new StringBuilder(text.length());
        int from = 0;
        for (int end = text.indexOf('\n'); end >= 0; end = text.indexOf('\n', from)) {
            line(text.substring(from, end), width, wrapped);
            wrapped.append('\n');
            from = end + 1;
        }
        line(text.substring(from), width, wrapped);
        return wrapped.toString();
    }

    private static void line(String line, int width, StringBuilder wrapped) {
        if (line.length() <= width || line.startsWith("{")) {
            wrapped.append(line);
            return;
        }
        int text = indent(line);
        int indent = Math.min(text, width / 2);
        // Never wrap within the indent.
        int begun = text == indent ? text : blanks(line);
        String rest = line.stripTrailing();
        while (rest.length() > width) {
            int blank = rest.lastIndexOf(' ', width);
            if (blank <= begun) {
                blank = rest.indexOf(' ', Math.max(begun, width));
            }
            if (blank < 0) {
                break;
            }
            wrapped.append(rest.substring(0, blank).stripTrailing()).append('\n');
            rest = " ".repeat(indent) + rest.substring(blank).strip();
            begun = indent;
        }
        wrapped.append(rest);
    }

    private static int indent(String line) {
        Matcher label = LABEL.matcher(line);
        return label.find() ? label.end() : blanks(line);
    }

    private static int blanks(String line) {
        return line.length() - line.stripLeading().length();
    }
}
