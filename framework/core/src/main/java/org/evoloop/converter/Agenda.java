package org.evoloop.converter;

import java.util.ArrayDeque;
import org.evoloop.core.Output;
import org.jspecify.annotations.Nullable;

/**
 * The directives to carry out in one turn, in order. The next turn continues with the same agenda. A thread whose turn
 * was taken away keeps the old agenda, which is over.
 *
 * <p>Threading: thread-safe. Only the thread that has the turn uses it, but one whose turn is being taken away may
 * return at the same moment.
 */
final class Agenda {
    /** The turn of a thread that opens or closes the converter, or ends what another thread has begun. */
    static final long NOBODY = 0;

    private final ArrayDeque<Output.Directive> directives = new ArrayDeque<>();
    private long turn = NOBODY;
    private @Nullable EventExecute settledFirst;
    private boolean over;

    /** The number of the occurrence in progress. */
    synchronized long turn() {
        return turn;
    }

    synchronized void begin(long number) {
        turn = number;
        settledFirst = null;
    }

    synchronized void add(Output.Directive directive) {
        directives.add(directive);
    }

    /** Removes and returns the next directive; null if there is none, or the turn was taken away. */
    synchronized Output.@Nullable Directive poll() {
        return over ? null : directives.poll();
    }

    /** The next directive, which stays on the agenda; null if there is none. */
    synchronized Output.@Nullable Directive peek() {
        return directives.peek();
    }

    /** Puts back the directive that was polled last, for another component to carry out. */
    synchronized void handBack(Output.Directive directive) {
        directives.addFirst(directive);
    }

    /** {@code execute} settles; returns the component that was the first to settle in this turn. */
    synchronized EventExecute settles(EventExecute execute) {
        EventExecute first = settledFirst == null ? execute : settledFirst;
        settledFirst = first;
        return first;
    }

    /** The component that was the first to settle in this turn; null if none has settled. */
    synchronized @Nullable EventExecute settledFirst() {
        return settledFirst;
    }

    /** Takes the turn away. Returns the agenda of the thread that continues, which holds what is left to do. */
    synchronized Agenda end() {
        over = true;
        Agenda rest = new Agenda();
        rest.directives.addAll(directives);
        directives.clear();
        return rest;
    }
}
