package org.evoloop.check.timing;

import java.util.ArrayDeque;
import java.util.Arrays;
import java.util.List;
import java.util.Set;
import java.util.stream.IntStream;
import org.evoloop.check.timing.Moves.Move;
import org.evoloop.engine.Rules;
import org.evoloop.statemachine.Event;

/**
 * Explores everything that can happen to a converter, tick by tick: fewest events first, and among these the least time
 * first.
 */
final class Exploration {
    /** How time passing is labelled. */
    static final int TICK = -1;

    static final int MOST_SITUATIONS = (1 << 15) - 1;

    final Clocks clocks;
    final Situations situations;
    final Rows rows;
    final Moves moves;
    final Visited visited;
    private final int most;
    private final int[] next;
    private final long[] key;

    /** Those that time has led to, and those that happenings have led to, each in order of time. */
    private final ArrayDeque<Integer> waited = new ArrayDeque<>();

    private ArrayDeque<Integer> happened = new ArrayDeque<>();
    private ArrayDeque<Integer> later = new ArrayDeque<>();
    private boolean[] done = new boolean[1 << 10];

    /** Receives the results. */
    interface Judge {
        /** A moment, before what can happen in it is tried. */
        default void looks(int number, int[] row, boolean blocked) {}

        /**
         * Something has happened, or time has passed; the rows contain what the monitors say about it.
         *
         * @param from the moment before; -1 at the beginning
         * @return whether to stop
         */
        boolean goes(int from, int label, Rows rows);
    }

    /**
     * @param forms what is watched, the first of which the rows measure
     * @param raised for each of them what follows from its violation
     * @param most the largest number of moments to explore
     */
    Exploration(
            Rules rules, TimeRules written, Clocks clocks, List<TimeForm> forms, List<Set<Event>> raised, int most) {
        this.clocks = clocks;
        this.most = most;
        this.situations = new Situations(rules, clocks.takes.keySet());
        Surroundings around = new Surroundings(rules.table(), written, clocks.comings);
        this.rows = new Rows(clocks, situations, around, raised);
        this.moves = new Moves(rules, clocks, situations, around, rows, forms, raised);
        this.visited = new Visited(clocks.packing.words());
        this.next = new int[clocks.length];
        this.key = new long[clocks.packing.words()];
    }

    /**
     * Explores until everything is done, or the judge stops it.
     *
     * @throws TooLargeException if there are too many moments
     */
    void run(Judge judge) {
        int[] row = rows.first();
        for (Edge edge : moves.opening()) {
            rows.happen(row, edge, -1, -1, next);
            if (judge.goes(-1, edge.number, rows)) {
                return;
            }
            arrive(-1, edge.number);
        }
        for (int number = poll(); number >= 0; number = poll()) {
            if (!done[number]) {
                done[number] = true;
                visited.get(number, clocks.packing, row);
                if (expand(number, row, judge)) {
                    return;
                }
            }
        }
    }

    private boolean expand(int number, int[] row, Judge judge) {
        boolean blocked = moves.isBlocked(row);
        judge.looks(number, row, blocked);
        if (take(number, row, moves.unasked(row), judge) || take(number, row, moves.asked(row), judge)) {
            return true;
        }
        if (!blocked) {
            rows.pass(row, next);
            if (judge.goes(number, TICK, rows)) {
                return true;
            }
            arrive(number, TICK);
        }
        return false;
    }

    private boolean take(int number, int[] row, List<Move> possible, Judge judge) {
        for (Move move : possible) {
            rows.happen(row, move.edge(), move.coming(), move.owed(), next);
            if (judge.goes(number, move.edge().number, rows)) {
                return true;
            }
            arrive(number, move.edge().number);
        }
        return false;
    }

    private void arrive(int from, int label) {
        clocks.packing.pack(next, key);
        int number = visited.number(key);
        int level = from < 0 ? 0 : visited.happenings(from) + (label == TICK ? 0 : 1);
        int time = from < 0 ? 0 : visited.time(from) + (label == TICK ? 1 : 0);
        boolean isNew = number < 0;
        number = isNew ? -1 - number : number;
        if (isNew && number >= most) {
            throw new TooLargeException("there are more than " + most + " moments, counted in ticks of "
                    + Span.length(clocks.ticks.nanos()));
        }
        if (number >= done.length) {
            done = Arrays.copyOf(done, 2 * done.length);
        }
        boolean isSooner = !isNew && !done[number] && level < visited.happenings(number);
        if (isNew || isSooner) {
            visited.reach(number, from, label, time, level);
            (label == TICK ? waited : later).add(number);
        }
    }

    private int poll() {
        if (waited.isEmpty() && happened.isEmpty()) {
            happened = later;
            later = new ArrayDeque<>();
        }
        Integer first = waited.peek();
        Integer second = happened.peek();
        if (first == null && second == null) {
            return -1;
        }
        boolean isFirst = second == null || (first != null && visited.time(first) <= visited.time(second));
        return isFirst ? waited.remove() : happened.remove();
    }

    /** The number of a row that was found. */
    int number(int[] row) {
        clocks.packing.pack(row, key);
        return visited.number(key);
    }

    /** The labels that lead to {@code number}, the first first. */
    int[] way(int number) {
        return IntStream.iterate(number, each -> each >= 0, visited::from).toArray();
    }
}
