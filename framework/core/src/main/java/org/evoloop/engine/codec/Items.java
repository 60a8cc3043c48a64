package org.evoloop.engine.codec;

import java.util.ArrayList;
import java.util.List;

/**
 * Items that were written, read one after another: groups of words, numbers, texts and names.
 *
 * <p>Errors: what cannot be read is a {@link CodecException}.
 *
 * <p>Threading: not thread-safe.
 *
 * @since 0.1
 */
public abstract class Items {
    Items() {}

    /**
     * The exception for something that does not fit the models, or cannot be read.
     *
     * @param remedy what to do
     */
    abstract CodecException wrong(String what, String remedy);

    /** The exception for bytes or text that were changed after they were written. */
    abstract CodecException damaged(String what);

    /** Advances to the next group, which must be {@code name}. */
    abstract void next(String name);

    /** Advances to the next group, and returns its name, one of several. */
    abstract String next();

    /** Requires the group to be read completely. */
    abstract void ends();

    /** Requires everything to be read. */
    public abstract void endsAll();

    /** Whether nothing follows in an optional group. */
    abstract boolean isNone();

    abstract String word();

    /** Reads one of two words: whether it is {@code yes}. */
    abstract boolean choice(String yes, String no);

    /** Reads the index of one of a few words. */
    abstract int choice(List<String> words);

    /** Reads a whole number. */
    public abstract long number();

    /** Reads a text. */
    public abstract String text();

    /** Reads a name. */
    public abstract String name();

    /** Reads a text, a number or a truth that an event carries. */
    abstract Object value();

    /** Reads true or false. */
    public final boolean truth() {
        return choice("true", "false");
    }

    /** Reads a count that may be very large. */
    final long total() {
        long total = number();
        if (total < 0) {
            throw damaged("no number below 0 was expected");
        }
        return total;
    }

    /** Reads a count. */
    public final int count() {
        long count = number();
        if (count < 0 || count > Integer.MAX_VALUE) {
            throw damaged("a count was expected, not " + count);
        }
        return (int) count;
    }

    /** Reads several names, their count first. */
    public final List<String> names() {
        int count = count();
        if (count == 0) {
            return List.of();
        }
        // Not of this size: a count that is wrong must not take all memory.
        List<String> names = new ArrayList<>();
        while (names.size() < count) {
            names.add(name());
        }
        return names;
    }
}
