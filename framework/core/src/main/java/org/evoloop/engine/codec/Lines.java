package org.evoloop.engine.codec;

import java.util.List;

/** The lines of a text, read one after another, word by word, in place: only requested words are copied. */
final class Lines extends Items {
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

    @Override
    CodecException wrong(String what, String remedy) {
        return new CodecException("snapshot, line " + number + ": " + what + "; " + remedy);
    }

    @Override
    CodecException damaged(String what) {
        return wrong(what, "the text is damaged, use another copy or start without it");
    }

    @Override
    void next(String first) {
        advance();
        int to = wordEnd(begin);
        if (to - begin != first.length() || !text.startsWith(first, begin)) {
            throw damaged("'" + first + "' was expected, not '" + text.substring(begin, to) + "'");
        }
        place = to;
    }

    @Override
    String next() {
        advance();
        return word();
    }

    private void advance() {
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

    @Override
    void ends() {
        if (place < end) {
            throw damaged("'" + text.substring(place, end).strip() + "' is too much");
        }
    }

    @Override
    public void endsAll() {
        ends();
        if (next < text.length()) {
            number++;
            throw damaged("there is more text after the end");
        }
    }

    private boolean isQuotedNext() {
        return place + 1 < end && text.charAt(place) == ' ' && text.charAt(place + 1) == '"';
    }

    @Override
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

    @Override
    boolean choice(String yes, String no) {
        String word = word();
        if (!word.equals(yes) && !word.equals(no)) {
            throw damaged("'" + yes + "' or '" + no + "' was expected, not '" + word + "'");
        }
        return word.equals(yes);
    }

    @Override
    int choice(List<String> words) {
        String word = word();
        if (!words.contains(word)) {
            throw damaged("'" + word + "' is none of " + words);
        }
        return words.indexOf(word);
    }

    @Override
    public long number() {
        int from = wordBegin();
        place = wordEnd(from);
        try {
            return Long.parseLong(text, from, place, DECIMAL);
        } catch (NumberFormatException e) {
            throw damaged("a number was expected, not '" + text.substring(from, place) + "'");
        }
    }

    @Override
    boolean isNone() {
        int to = wordEnd(Math.min(place + 1, end));
        if (!text.startsWith(" none", place) || to - place != " none".length()) {
            return false;
        }
        place = to;
        return true;
    }

    @Override
    Object value() {
        if (isQuotedNext()) {
            return text();
        }
        String word = word();
        if (word.equals("true") || word.equals("false")) {
            return word.equals("true");
        }
        try {
            return Double.valueOf(word);
        } catch (NumberFormatException e) {
            throw damaged("'" + word + "' is not a value");
        }
    }

    @Override
    public String name() {
        return text();
    }

    @Override
    public String text() {
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

    private CodecException open() {
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
