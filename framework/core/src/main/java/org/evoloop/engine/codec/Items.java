package org.evoloop.engine.codec;

import java.util.ArrayList;
import java.util.List;

/** The items of a snapshot, read one after another: groups of words, numbers and texts. */
abstract class Items {
    /** The exception for something that does not fit the models, or cannot be read. */
    abstract SnapshotException wrong(String what);

    /** The exception for bytes or text that were changed after they were written. */
    abstract SnapshotException damaged(String what);

    /** Advances to the next group, which must be {@code name}. */
    abstract void next(String name);

    /** Advances to the next group, and returns its name, one of several. */
    abstract String next();

    /** Requires the group to be read completely. */
    abstract void ends();

    /** Requires everything to be read. */
    abstract void endsAll();

    /** Whether nothing follows in an optional group. */
    abstract boolean isNone();

    abstract String word();

    /** Reads one of two words: whether it is {@code yes}. */
    abstract boolean choice(String yes, String no);

    /** Reads the index of one of a few words. */
    abstract int choice(List<String> words);

    abstract long number();

    abstract String text();

    /** Reads a text, a number or a truth that an event carries. */
    abstract Object value();

    /** Reads a count that may be very large. */
    final long total() {
        long total = number();
        if (total < 0) {
            throw damaged("no number below 0 was expected");
        }
        return total;
    }

    /** Reads a count. */
    final int count() {
        long count = number();
        if (count < 0 || count > Integer.MAX_VALUE) {
            throw damaged("a count was expected, not " + count);
        }
        return (int) count;
    }

    /** Reads several texts, their count first. */
    final List<String> texts() {
        int count = count();
        if (count == 0) {
            return List.of();
        }
        List<String> texts = new ArrayList<>();
        while (texts.size() < count) {
            texts.add(text());
        }
        return texts;
    }
}
