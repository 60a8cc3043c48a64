package org.evoloop.evolution;

import java.util.Arrays;
import java.util.function.ToIntFunction;
import org.jspecify.annotations.Nullable;

/**
 * Where the decisions of a table are kept: a cell for each event in each situation, found by their numbers. As long as
 * that is not too much the cells stand in rows, one after the other; else, with very many events in very many
 * situations, only the cells that are in use have a place, found by hashing.
 *
 * <p>Threading: not thread-safe while it is written, thread-safe afterwards.
 */
final class DecisionCells {
    /** So many cells, 8 bytes each, may stand in rows. */
    private static final long MOST_IN_ROWS = 1L << 22;

    /** No situation's number: it has not been asked for. */
    static final int UNKNOWN = -1;

    /** What a cell without a decision leads to. */
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

    /** Makes room for the decisions of a situation; before that it must not be asked for. */
    void open(int situation) {
        long cells = key(situation + 1, 0);
        if (!hashed && cells > MOST_IN_ROWS) {
            hash();
        } else if (!hashed && cells > decisions.length) {
            makeRows((int) Math.min(MOST_IN_ROWS, Math.max(cells, 2L * decisions.length)));
        }
    }

    /** The decision in a cell; null if none was put there. */
    @Nullable
    Decision get(int situation, int event) {
        return decisions[placeOf(situation, event)];
    }

    /** The number of the situation that the decision in a cell leads to, or {@link #UNKNOWN}; without one it is the same. */
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

    /** Notes the number of the situation that the decision in a cell leads to. */
    void lead(int situation, int event, int next) {
        after[placeOf(situation, event)] = next;
    }

    /** Notes it for every decision for which that was not done. */
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

    /** Where a cell is, or with hashing where it would be. Rows are only made as far as an int can count. */
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

    /** From rows to hashing. */
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

    /** Where the key is, or where it would be. */
    private int find(long key) {
        int mask = keys.length - 1;
        int place = (int) ((key * 0x9E3779B97F4A7C15L) >>> 40) & mask;
        while (keys[place] != key && keys[place] != EMPTY) {
            place = (place + 1) & mask;
        }
        return place;
    }
}
