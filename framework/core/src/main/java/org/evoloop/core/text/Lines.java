package org.evoloop.core.text;

import java.util.ArrayList;
import java.util.List;

/** The lines of a text, read one after another, word by word, in place: only requested words are copied. */
final class Lines {
    private static final int DECIMAL = 10;

    private final String text;
    private int number;

    /** Where the line begins and ends, and how far it has been read. */
    private int begin;

    private int end;
    private int place;

    /** Where the next line begins. */
    private int next;

    Lines(String text) {
        this.text = text;
    }

    SnapshotException wrong(String what) {
        return new SnapshotException("snapshot, line " + number + ": " + what);
    }

    SnapshotException damaged(String what) {
        return wrong(what + "; the text is damaged, use another copy or start without it");
    }

    /** Advances to the next line, which must begin with {@code first}. */
    void next(String first) {
        goOn();
        int to = wordEnd(begin);
        if (to - begin != first.length() || !text.startsWith(first, begin)) {
            throw damaged("'" + first + "' was expected, not '" + text.substring(begin, to) + "'");
        }
        place = to;
    }

    /** Advances to the next line, and returns its first word. */
    String next() {
        goOn();
        return word();
    }

    private void goOn() {
        number++;
        if (next >= text.length()) {
            throw damaged("the text ends too early");
        }
        begin = next;
        int feed = text.indexOf('\n', begin);
        end = feed < 0 ? text.length() : feed;
        next = feed < 0 ? end : feed + 1;
        if (end > begin && text.charAt(end - 1) == '\r') {
            end--;
        }
        place = begin;
    }

    private int wordEnd(int from) {
        int at = from;
        while (at < end && text.charAt(at) != ' ') {
            at++;
        }
        return at;
    }

    /** Requires the line to be read completely. */
    void ends() {
        if (place < end) {
            throw damaged("'" + text.substring(place, end).strip() + "' is too much");
        }
    }

    /** Requires the text to end here. */
    void endsAll() {
        ends();
        if (next < text.length()) {
            number++;
            throw damaged("there is more text after the end");
        }
    }

    boolean isQuotedNext() {
        return place + 1 < end && text.charAt(place) == ' ' && text.charAt(place + 1) == '"';
    }

    /** Reads a word without quotes. */
    String word() {
        int from = wordBegin();
        place = wordEnd(from);
        return text.substring(from, place);
    }

    private int wordBegin() {
        return place == begin ? begin : separated();
    }

    private int separated() {
        if (place >= end || text.charAt(place) != ' ') {
            throw damaged("the line ends too early");
        }
        return place + 1;
    }

    /** Reads one of two words: whether it is {@code yes}. */
    boolean choice(String yes, String no) {
        String word = word();
        if (!word.equals(yes) && !word.equals(no)) {
            throw damaged("'" + yes + "' or '" + no + "' was expected, not '" + word + "'");
        }
        return word.equals(yes);
    }

    long number() {
        int from = wordBegin();
        place = wordEnd(from);
        try {
            return Long.parseLong(text, from, place, DECIMAL);
        } catch (NumberFormatException e) {
            throw noNumber(text.substring(from, place));
        }
    }

    private SnapshotException noNumber(String word) {
        return damaged("a number was expected, not '" + word + "'");
    }

    /** Parses {@code word} as a number. */
    long numberIn(String word) {
        try {
            return Long.parseLong(word);
        } catch (NumberFormatException e) {
            throw noNumber(word);
        }
    }

    /** Reads a count that may be very large. */
    long total() {
        long total = number();
        if (total < 0) {
            throw damaged("no number below 0 was expected");
        }
        return total;
    }

    /** Reads a count. */
    int count() {
        return counted(number());
    }

    /** Parses {@code word} as a count. */
    int countIn(String word) {
        return counted(numberIn(word));
    }

    private int counted(long count) {
        if (count < 0 || count > Integer.MAX_VALUE) {
            throw damaged("a count was expected, not " + count);
        }
        return (int) count;
    }

    /** Reads a text in quotes. */
    String text() {
        if (!isQuotedNext()) {
            throw damaged("a quoted string was expected");
        }
        int from = separated() + 1;
        int at = from;
        while (at < end && text.charAt(at) != '"' && text.charAt(at) != '\\') {
            at++;
        }
        if (at >= end) {
            throw open();
        } else if (text.charAt(at) == '\\') {
            return withEscapes(from);
        }
        place = at + 1;
        return text.substring(from, at);
    }

    private SnapshotException open() {
        return damaged("a string has no closing quote");
    }

    private String withEscapes(int from) {
        StringBuilder plain = new StringBuilder();
        int at = from;
        for (; at < end && text.charAt(at) != '"'; at++) {
            char each = text.charAt(at);
            if (each != '\\') {
                plain.append(each);
            } else if (at + 1 < end && text.charAt(at + 1) == 'u') {
                plain.append(escaped(at + 2));
                at += 5;
            } else {
                at++;
                boolean known = at < end && (text.charAt(at) == '"' || text.charAt(at) == '\\');
                plain.append(known ? text.charAt(at) : bad());
            }
        }
        if (at >= end) {
            throw open();
        }
        place = at + 1;
        return plain.toString();
    }

    /** Reads several texts, their count first. */
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
            return (char) Integer.parseInt(text, Math.min(end, at), Math.min(end, at + 4), 16);
        } catch (NumberFormatException e) {
            return bad();
        }
    }

    private char bad() {
        throw damaged("a string has an unknown escape sequence");
    }
}
