package org.evoloop.converter;

import java.util.ArrayDeque;
import org.evoloop.core.Output;
import org.jspecify.annotations.Nullable;

/**
 * What has to be done in one turn, in order. The next turn continues with the same agenda, unless the turn was taken
 * away from a thread: that thread keeps the old agenda, which is over.
 *
 * <p>Threading: only the thread that has the turn adds and removes directives, so no lock is needed for each
 * directive.
 */
final class Agenda {
    /** The turn of a thread that opens or closes the converter, or ends what another thread has begun. */
    static final long NOBODY = 0;

    private final ArrayDeque<Output.Directive> directives = new ArrayDeque<>();
    private long turn = NOBODY;
    private volatile boolean over;

    /** The number of the occurrence that has its turn. */
    long turn() {
        return turn;
    }

    void begin(long number) {
        turn = number;
    }

    void add(Output.Directive directive) {
        directives.add(directive);
    }

    /** What has to be done next, which is off the agenda then; null if there is nothing, or the turn was taken away. */
    Output.@Nullable Directive poll() {
        return over ? null : directives.poll();
    }

    /** What has to be done next; null if there is nothing. */
    Output.@Nullable Directive peek() {
        return directives.peek();
    }

    /** Puts back what was polled last: another component has to do it. */
    void handBack(Output.Directive directive) {
        directives.addFirst(directive);
    }

    /** Takes the turn away. */
    void end() {
        over = true;
    }
}
