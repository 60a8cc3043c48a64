package org.evoloop.engine.codec;

import java.util.Collection;
import java.util.List;

/** Writes the items that {@link Items} reads. */
abstract class ItemWriter {
    /** Begins a group of this name. */
    abstract ItemWriter begin(String name);

    /** Begins a group whose name is one of several. */
    abstract ItemWriter beginKind(String name);

    /** Begins an optional group that has contents. */
    abstract ItemWriter beginSome(String name);

    /** Writes an optional group that has none. */
    abstract void none(String name);

    abstract ItemWriter word(String word);

    abstract ItemWriter choice(boolean which, String yes, String no);

    /** Writes one of a few words, by its index. */
    abstract ItemWriter choice(int which, List<String> words);

    abstract ItemWriter number(long number);

    abstract ItemWriter text(String text);

    /** Writes a {@link String}, {@link Double} or {@link Boolean}. */
    abstract ItemWriter value(Object value);

    /** Ends the group. */
    abstract void end();

    final ItemWriter truth(boolean truth) {
        return choice(truth, "true", "false");
    }

    final ItemWriter texts(Collection<String> texts) {
        number(texts.size());
        for (String text : texts) {
            text(text);
        }
        return this;
    }
}
