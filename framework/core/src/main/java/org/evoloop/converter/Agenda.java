package org.evoloop.converter;

import java.util.ArrayDeque;
import org.evoloop.core.Output;
import org.jspecify.annotations.Nullable;

/**
 * The directives to carry out in one turn, in order. The next turn continues with the same agenda. A thread whose turn
 * was taken away keeps the old agenda, which is closed.
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

    /** The number of the occurrence in progress. */
    long turn() {
        return turn;
    }

    void begin(long number) {
        turn = number;
    }

    void add(Output.Directive directive) {
        directives.add(directive);
    }

    /** Removes and returns the next directive; null if there is none, or the turn was taken away. */
    Output.@Nullable Directive poll() {
        return over ? null : directives.poll();
    }

    /** The next directive, which stays on the agenda; null if there is none. */
    Output.@Nullable Directive peek() {
        return directives.peek();
    }

    /** Puts back the directive that was polled last, for another component to carry out. */
    void handBack(Output.Directive directive) {
        directives.addFirst(directive);
    }

    /** Takes the turn away. */
    void end() {
        over = true;
    }
}
