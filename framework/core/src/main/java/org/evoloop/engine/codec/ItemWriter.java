package org.evoloop.engine.codec;

import java.util.Collection;
import java.util.List;

/**
 * Writes the items that {@link Items} reads.
 *
 * <p>Threading: not thread-safe.
 *
 * @since 0.1
 */
public abstract class ItemWriter {
    ItemWriter() {}

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

    /** Writes a whole number. */
    public abstract ItemWriter number(long number);

    /** Writes a text that is unlikely to be repeated. */
    public abstract ItemWriter text(String text);

    /** Writes a name of the models, or another text that is repeated. */
    public abstract ItemWriter name(String name);

    /** Writes a {@link String}, {@link Double} or {@link Boolean}. */
    abstract ItemWriter value(Object value);

    /** Ends the group. */
    abstract void end();

    /** Writes true or false. */
    public final ItemWriter truth(boolean truth) {
        return choice(truth, "true", "false");
    }

    /** Writes several names, their count first. */
    public final ItemWriter names(Collection<String> names) {
        number(names.size());
        // Most are none, and need no iterator then.
        if (!names.isEmpty()) {
            for (String name : names) {
                name(name);
            }
        }
        return this;
    }
}
