package org.evoloop.xmi.text;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

/**
 * The lines of a text that is edited. Only lines that an edit concerns change, so what ends the others stays.
 *
 * <p>Threading: for one thread.
 */
final class Lines {
    private static final String ENDS = "\r\n";

    private final List<String> lines;

    /** The lines of {@code text}. */
    Lines(String text) {
        lines = new ArrayList<>(Arrays.asList(text.split("(?<=\n)|(?<=\r)(?!\n)", -1)));
        if (lines.get(lines.size() - 1).isEmpty()) {
            lines.remove(lines.size() - 1);
        }
    }

    /** How many there are. */
    int count() {
        return lines.size();
    }

    /** The line with this number, from 1, without what ends it. */
    String get(int number) {
        String line = lines.get(number - 1);
        int end = line.length();
        while (end > 0 && ENDS.indexOf(line.charAt(end - 1)) >= 0) {
            end--;
        }
        return line.substring(0, end);
    }

    /** Replaces a part of a line. */
    void replace(int number, int from, int to, String by) {
        String line = lines.get(number - 1);
        lines.set(number - 1, line.substring(0, from) + by + line.substring(to));
    }

    /** Replaces a line. */
    void set(int number, String content) {
        replace(number, 0, get(number).length(), content);
    }

    /** Inserts a line, so that it has this number. */
    void insert(int number, String content) {
        int before = number - 1;
        String end = "\n";
        if (before > 0) {
            String above = lines.get(before - 1);
            String itsEnd = above.substring(get(before).length());
            end = itsEnd.isEmpty() ? end : itsEnd;
            if (itsEnd.isEmpty()) {
                // The last line had no end, and the new last one will have none.
                lines.set(before - 1, above + end);
                lines.add(before, content);
                return;
            }
        }
        lines.add(before, content + end);
    }

    /** Removes a line; if it was the last and had no end, the one before loses its end. */
    void remove(int number) {
        boolean last = number == lines.size() && lines.get(number - 1).equals(get(number));
        lines.remove(number - 1);
        if (last && number > 1) {
            lines.set(number - 2, get(number - 1));
        }
    }

    /** The blanks before a line. */
    String indent(int number) {
        String line = get(number);
        return line.substring(0, line.length() - line.stripLeading().length());
    }

    /** The whole text. */
    @Override
    public String toString() {
        return String.join("", lines);
    }
}
