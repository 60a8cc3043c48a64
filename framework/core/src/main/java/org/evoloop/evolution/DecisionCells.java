package org.evoloop.evolution;

import java.util.Arrays;
import java.util.function.ToIntFunction;
import org.jspecify.annotations.Nullable;

/**
 * The storage of a decision table: a cell for each event in each situation, found by their numbers. Up to a limit the
 * cells form a dense matrix; beyond it, with very many events in very many situations, only the cells in use are
 * stored, found by hashing.
 *
 * <p>Threading: not thread-safe while it is written, thread-safe afterwards.
 */
final class DecisionCells {
    /** The largest number of cells, 8 bytes each, of the dense matrix. */
    private static final long MOST_IN_ROWS = 1L << 22;

    /** The number of the next situation has not been looked up yet. */
    static final int UNKNOWN = -1;

    /** The next situation of a cell without a decision: the same one. */
    private static final int STAYS = -2;

    private static final long EMPTY = -1;

    private final int width;
    private long[] keys = {};
    private @Nullable Decision[] decisions = {};
    private int[] after = {};
    private int used;
    private boolean hashed;

    /** @param width how many events there are */
    DecisionCells(int width) {
        this.width = Math.max(1, width);
    }

    /** Makes room for the decisions of a situation, before any access to them. */
    void open(int situation) {
        long cells = key(situation + 1, 0);
        if (!hashed && cells > MOST_IN_ROWS) {
            hash();
        } else if (!hashed && cells > decisions.length) {
            makeRows((int) Math.min(MOST_IN_ROWS, Math.max(cells, 2L * decisions.length)));
        }
    }

    /** The decision in a cell; null if there is none. */
    @Nullable
    Decision get(int situation, int event) {
        return decisions[placeOf(situation, event)];
    }

    /**
     * The number of the situation to which the decision in a cell leads, or {@link #UNKNOWN}; the same situation if
     * there is no decision.
     */
    int after(int situation, int event) {
        int next = after[placeOf(situation, event)];
        return next == STAYS ? situation : next;
    }

    void put(int situation, int event, Decision decision) {
        set(hashed ? makePlace(key(situation, event)) : placeOf(situation, event), decision, UNKNOWN);
    }

    private void set(int place, @Nullable Decision decision, int next) {
        decisions[place] = decision;
        after[place] = next;
    }

    /** Sets the number of the situation to which the decision in a cell leads. */
    void lead(int situation, int event, int next) {
        after[placeOf(situation, event)] = next;
    }

    /** Sets it for every decision for which it is still unknown. */
    void link(ToIntFunction<Decision> numberOf) {
        for (int place = 0; place < decisions.length; place++) {
            Decision decision = decisions[place];
            if (decision != null && after[place] == UNKNOWN) {
                after[place] = numberOf.applyAsInt(decision);
            }
        }
    }

    private long key(int situation, int event) {
        return (long) situation * width + event;
    }

    /**
     * The index of a cell; with hashing, also of one that is not stored. The matrix never exceeds the range of an int.
     */
    private int placeOf(int situation, int event) {
        return hashed ? find(key(situation, event)) : situation * width + event;
    }

    private int makePlace(long key) {
        int place = find(key);
        if (keys[place] == EMPTY) {
            if (2 * ++used > keys.length) {
                rehash(2 * keys.length);
                place = find(key);
            }
            keys[place] = key;
        }
        return place;
    }

    private void makeRows(int cells) {
        int before = decisions.length;
        decisions = Arrays.copyOf(decisions, cells);
        after = Arrays.copyOf(after, cells);
        Arrays.fill(after, before, cells, STAYS);
    }

    /** Switches from the matrix to hashing. */
    private void hash() {
        @Nullable Decision[] rows = decisions;
        int[] rowsAfter = after;
        hashed = true;
        empty(1 << 16);
        for (int key = 0; key < rows.length; key++) {
            Decision decision = rows[key];
            if (decision != null) {
                set(makePlace(key), decision, rowsAfter[key]);
            }
        }
    }

    private void empty(int size) {
        keys = new long[size];
        Arrays.fill(keys, EMPTY);
        decisions = new Decision[size];
        after = new int[size];
        Arrays.fill(after, STAYS);
    }

    private void rehash(int size) {
        long[] oldKeys = keys;
        @Nullable Decision[] oldDecisions = decisions;
        int[] oldAfter = after;
        empty(size);
        for (int old = 0; old < oldKeys.length; old++) {
            if (oldKeys[old] != EMPTY) {
                int place = find(oldKeys[old]);
                keys[place] = oldKeys[old];
                set(place, oldDecisions[old], oldAfter[old]);
            }
        }
    }

    /** The index of the key, or the one where it would be stored. */
    private int find(long key) {
        int mask = keys.length - 1;
        int place = (int) ((key * 0x9E3779B97F4A7C15L) >>> 40) & mask;
        while (keys[place] != key && keys[place] != EMPTY) {
            place = (place + 1) & mask;
        }
        return place;
    }
}
