package org.evoloop.xmi.text;

import java.util.Locale;

/**
 * A place in a line that is being read.
 *
 * <p>Threading: for one thread.
 */
final class Cursor {
    private final String text;
    private final int line;
    private int at;

    /** @param line its number, counted from 1 */
    Cursor(String text, int line) {
        this.text = text;
        this.line = line;
    }

    int line() {
        return line;
    }

    /** Counted from 1. */
    int column() {
        return at + 1;
    }

    /** Moves back to a column that was read before. */
    void backTo(int column) {
        at = column - 1;
    }

    /** Skips blanks; returns whether anything follows. */
    boolean hasMore() {
        while (at < text.length() && isBlank(text.charAt(at))) {
            at++;
        }
        return at < text.length();
    }

    private static boolean isBlank(char letter) {
        return Character.isWhitespace(letter) || letter == '\u00a0';
    }

    boolean isAt(String begin) {
        return text.startsWith(begin, at);
    }

    /** The next letter; a blank at the end. */
    char letter() {
        return at < text.length() ? text.charAt(at) : ' ';
    }

    /** Moves behind the text if it is here. */
    boolean take(String expected) {
        boolean here = isAt(expected);
        at += here ? expected.length() : 0;
        return here;
    }

    /** Moves behind the word if it is here, in any case, and ends here. */
    boolean takeWord(String word) {
        int end = at + word.length();
        boolean here = text.regionMatches(true, at, word, 0, word.length())
                && (end == text.length() || isBlank(text.charAt(end)));
        at = here ? end : at;
        return here;
    }

    /** The longest id that begins here; empty if none does. */
    String id(Syntax syntax) {
        int from = at;
        while (at < text.length() && syntax.isIdPart(text.charAt(at))) {
            at++;
        }
        return text.substring(from, at);
    }

    /** The letters of the word that begins here, in lower case, without moving. */
    String word() {
        int end = at;
        while (end < text.length() && Character.isLetter(text.charAt(end))) {
            end++;
        }
        return text.substring(at, end).toLowerCase(Locale.ROOT);
    }

    /** The text up to {@code end}, behind which it moves; everything that is left if {@code end} does not come. */
    String upTo(String end) {
        int to = text.indexOf(end, at);
        String taken = text.substring(at, to < 0 ? text.length() : to);
        at = to < 0 ? text.length() : to + end.length();
        return taken;
    }

    /** Whether the text comes later in the line. */
    boolean comesLater(String later) {
        return text.indexOf(later, at) >= 0;
    }

    /** What has been read from {@code column} on. */
    String since(int column) {
        return text.substring(column - 1, at);
    }

    /** What is left, to whose end it moves. */
    String rest() {
        String rest = text.substring(at);
        at = text.length();
        return rest;
    }

    /** What is left, without moving. */
    String ahead() {
        return text.substring(at);
    }
}
