package org.evoloop.engine.codec;

import java.util.List;

/** Writes items as lines. */
final class LineWriter extends ItemWriter {
    /** Large enough for most snapshots. */
    private static final int CAPACITY = 512;

    private final StringBuilder text = new StringBuilder(CAPACITY);

    String written() {
        return text.toString();
    }

    @Override
    ItemWriter begin(String name) {
        text.append(name);
        return this;
    }

    @Override
    ItemWriter beginKind(String name) {
        return begin(name);
    }

    @Override
    ItemWriter beginSome(String name) {
        return begin(name);
    }

    @Override
    void none(String name) {
        begin(name).word("none").end();
    }

    @Override
    ItemWriter word(String word) {
        text.append(' ').append(word);
        return this;
    }

    @Override
    ItemWriter choice(boolean which, String yes, String no) {
        return word(which ? yes : no);
    }

    @Override
    ItemWriter choice(int which, List<String> words) {
        return word(words.get(which));
    }

    @Override
    public ItemWriter number(long number) {
        text.append(' ').append(number);
        return this;
    }

    @Override
    public ItemWriter text(String words) {
        text.append(' ');
        Quoted.append(text, words);
        return this;
    }

    @Override
    public ItemWriter name(String name) {
        return text(name);
    }

    @Override
    ItemWriter value(Object value) {
        return value instanceof String words ? text(words) : word(value.toString());
    }

    @Override
    void end() {
        text.append('\n');
    }
}
