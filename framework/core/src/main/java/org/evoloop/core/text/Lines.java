package org.evoloop.core.text;

import java.util.ArrayList;
import java.util.List;

/** The lines of a text, read one after the other, word by word. */
final class Lines {
    private final List<String> lines;
    private String line = "";
    private int number;
    private int place;

    Lines(String text) {
        lines = text.lines().toList();
    }

    SnapshotException wrong(String what) {
        return new SnapshotException("snapshot, line " + number + ": " + what);
    }

    SnapshotException damaged(String what) {
        return wrong(what + "; the text is damaged, use another copy or begin without it");
    }

    /** Goes on to the next line, which must begin with {@code first}. */
    void next(String first) {
        String found = next();
        if (!found.equals(first)) {
            throw damaged("'" + first + "' was expected, not '" + found + "'");
        }
    }

    /** Goes on to the next line, and returns how it begins. */
    String next() {
        number++;
        if (number > lines.size()) {
            throw damaged("the text ends too early");
        }
        line = lines.get(number - 1);
        place = 0;
        return word();
    }

    /** The line must have been read to its end. */
    void ends() {
        if (place < line.length()) {
            throw damaged("'" + line.substring(place).strip() + "' is too much");
        }
    }

    /** Nothing must follow. */
    void endsAll() {
        ends();
        if (number < lines.size()) {
            number++;
            throw damaged("something follows after the end");
        }
    }

    boolean isQuotedNext() {
        return line.startsWith(" \"", place);
    }

    /** A word without quotes. */
    String word() {
        int from = place == 0 ? 0 : separated();
        int to = line.indexOf(' ', from);
        place = to < 0 ? line.length() : to;
        return line.substring(from, place);
    }

    private int separated() {
        if (place >= line.length() || line.charAt(place) != ' ') {
            throw damaged("the line ends too early");
        }
        return place + 1;
    }

    /** One of two words: whether it is {@code yes}. */
    boolean choice(String yes, String no) {
        String word = word();
        if (!word.equals(yes) && !word.equals(no)) {
            throw damaged("'" + yes + "' or '" + no + "' was expected, not '" + word + "'");
        }
        return word.equals(yes);
    }

    long number() {
        return numberIn(word());
    }

    /** The number that {@code word} is. */
    long numberIn(String word) {
        try {
            return Long.parseLong(word);
        } catch (NumberFormatException e) {
            throw damaged("a number was expected, not '" + word + "'");
        }
    }

    /** How many there are of something, which may be very many. */
    long total() {
        long total = number();
        if (total < 0) {
            throw damaged("no number below 0 was expected");
        }
        return total;
    }

    /** How many there are of something. */
    int count() {
        return countIn(word());
    }

    /** The count that {@code word} is. */
    int countIn(String word) {
        long count = numberIn(word);
        if (count < 0 || count > Integer.MAX_VALUE) {
            throw damaged("a count was expected, not " + count);
        }
        return (int) count;
    }

    /** A text in quotes. */
    String text() {
        if (!isQuotedNext()) {
            throw damaged("a text in quotes was expected");
        }
        int at = separated();
        StringBuilder text = new StringBuilder();
        for (at++; at < line.length() && line.charAt(at) != '"'; at++) {
            char each = line.charAt(at);
            if (each != '\\') {
                text.append(each);
            } else if (line.startsWith("u", at + 1)) {
                text.append(escaped(at + 2));
                at += 5;
            } else {
                at++;
                text.append(line.startsWith("\"", at) || line.startsWith("\\", at) ? line.charAt(at) : bad());
            }
        }
        if (at >= line.length()) {
            throw damaged("a text has no closing quote");
        }
        place = at + 1;
        return text.toString();
    }

    /** Several texts, their count first. */
    List<String> texts() {
        int count = count();
        List<String> texts = new ArrayList<>();
        while (texts.size() < count) {
            texts.add(text());
        }
        return texts;
    }

    private char escaped(int at) {
        try {
            return (char) Integer.parseInt(line.substring(at, Math.min(line.length(), at + 4)), 16);
        } catch (NumberFormatException e) {
            return bad();
        }
    }

    private char bad() {
        throw damaged("a text has an escape that does not exist");
    }
}
