package org.evoloop.converter.running;

import java.util.Arrays;
import java.util.concurrent.atomic.AtomicIntegerFieldUpdater;
import org.evoloop.converter.attachment.ExecuteAccess;
import org.evoloop.engine.Output;
import org.jspecify.annotations.Nullable;

/**
 * The directives to carry out in one turn, in order. The next turn continues with the same agenda. A thread whose turn
 * was taken away keeps the old agenda, which is over.
 *
 * <p>Threading: for the thread that has the turn; directives are added under the lock of the {@link CoreDriver}, and the
 * turn is taken away under it. A thread that takes a directive at that moment gets it either before or not at all, so no
 * lock is needed for each directive.
 */
final class Agenda {
    /** The turn of a thread that opens or closes the converter, or ends what another thread has begun. */
    static final long NOBODY = 0;

    private static final AtomicIntegerFieldUpdater<Agenda> TAKEN =
            AtomicIntegerFieldUpdater.newUpdater(Agenda.class, "taken");

    private static final int OVER = -1;
    private static final int USUAL = 8;

    private Output.Directive[] directives = new Output.Directive[USUAL];
    private int added;

    /** How many of the directives have been taken; {@value #OVER} if the turn was taken away. */
    private volatile int taken;

    private long turn = NOBODY;
    private @Nullable ExecuteAccess settledFirst;

    /** The number of the occurrence in progress. */
    long turn() {
        return turn;
    }

    void begin(long number) {
        turn = number;
        settledFirst = null;
    }

    void add(Output.Directive directive) {
        if (taken == added && TAKEN.compareAndSet(this, added, 0)) {
            added = 0;
        }
        if (added == directives.length) {
            directives = Arrays.copyOf(directives, 2 * added);
        }
        directives[added] = directive;
        added++;
    }

    /** Removes and returns the next directive; null if there is none, or the turn was taken away. */
    Output.@Nullable Directive poll() {
        int next = taken;
        Output.Directive directive = peek(next);
        return directive != null && TAKEN.compareAndSet(this, next, next + 1) ? directive : null;
    }

    /** The next directive, which stays on the agenda; null if there is none, or the turn was taken away. */
    Output.@Nullable Directive peek() {
        return peek(taken);
    }

    private Output.@Nullable Directive peek(int next) {
        return next == OVER || next == added ? null : directives[next];
    }

    /** Puts back the directive that was polled last, for another component to carry out. */
    void handBack() {
        int next = taken;
        if (next > 0) {
            TAKEN.compareAndSet(this, next, next - 1);
        }
    }

    /** {@code execute} settles; returns the component that was the first to settle in this turn. */
    ExecuteAccess settles(ExecuteAccess execute) {
        ExecuteAccess first = settledFirst == null ? execute : settledFirst;
        settledFirst = first;
        return first;
    }

    /** The component that was the first to settle in this turn; null if none has settled. */
    @Nullable
    ExecuteAccess settledFirst() {
        return settledFirst;
    }

    /** Takes the turn away. Returns the agenda of the thread that continues, which holds what is left to do. */
    Agenda end() {
        Agenda rest = new Agenda();
        int left = TAKEN.getAndSet(this, OVER);
        for (int next = left; left != OVER && next < added; next++) {
            rest.add(directives[next]);
        }
        return rest;
    }
}
