package org.evoloop.xmi.text;

import org.jspecify.annotations.Nullable;

/**
 * A statement that was read, and where it is: for edits of the text. Columns are counted from 0.
 *
 * @param line in the file, from 1
 * @param scope the region in which it is; of what opens or closes a state, the one outside
 * @param first the state that it is about, or the source of its arrow; null for none
 * @param second the target of its arrow; null for no arrow
 * @param text where its label or description begins; -1 for none
 * @param shown where the text in its quotation marks is; null for none
 */
record Statement(
        int line,
        Kind kind,
        Scope scope,
        @Nullable Mark first,
        @Nullable Mark second,
        int text,
        @Nullable Mark shown) {
    /** What a statement says. */
    enum Kind {
        ARROW,
        DESCRIPTION,
        DECLARATION,
        /** A declaration that is followed by the state's contents. */
        OPENING,
        CLOSING,
        SEPARATOR
    }

    /**
     * A part of a line.
     *
     * @param id of a state; of a text in quotation marks, the text; empty for {@code [*]} and histories
     */
    record Mark(String id, int from, int to) {}

    /** Whether it names the state. */
    boolean names(String id) {
        return (first != null && first.id().equals(id))
                || (second != null && second.id().equals(id));
    }
}
