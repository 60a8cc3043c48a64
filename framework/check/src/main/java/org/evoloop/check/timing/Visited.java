package org.evoloop.check.timing;

import java.util.Arrays;

/** The moments found, numbered in order, each with how and when it was first reached. */
final class Visited {
    private final int words;
    private long[] keys;
    private int[] from;
    private int[] label;
    private int[] time;
    private int[] happenings;
    private int[] table = new int[1 << 12];
    private int size;

    Visited(int words) {
        this.words = words;
        this.keys = new long[words << 10];
        this.from = new int[1 << 10];
        this.label = new int[1 << 10];
        this.time = new int[1 << 10];
        this.happenings = new int[1 << 10];
    }

    int size() {
        return size;
    }

    /** The number of {@code key}; {@code -1 - number} if it was not known before. */
    int number(long[] key) {
        int slot = slot(key);
        if (table[slot] != 0) {
            return table[slot] - 1;
        }
        if (size == from.length) {
            grow();
        }
        System.arraycopy(key, 0, keys, size * words, words);
        table[slot] = ++size;
        if (size * 2 > table.length) {
            rehash();
        }
        return -size;
    }

    private int slot(long[] key) {
        int slot = hash(key, 0) & table.length - 1;
        while (table[slot] != 0 && !isAt(table[slot] - 1, key)) {
            slot = slot + 1 & table.length - 1;
        }
        return slot;
    }

    private boolean isAt(int number, long[] key) {
        for (int word = 0; word < words; word++) {
            if (keys[number * words + word] != key[word]) {
                return false;
            }
        }
        return true;
    }

    private int hash(long[] of, int offset) {
        long hash = 0;
        for (int word = 0; word < words; word++) {
            hash = (hash ^ of[offset + word]) * 0x9E3779B97F4A7C15L;
            hash ^= hash >>> 29;
        }
        return (int) (hash ^ hash >>> 32);
    }

    private void grow() {
        int larger = from.length * 2;
        keys = Arrays.copyOf(keys, larger * words);
        from = Arrays.copyOf(from, larger);
        label = Arrays.copyOf(label, larger);
        time = Arrays.copyOf(time, larger);
        happenings = Arrays.copyOf(happenings, larger);
    }

    private void rehash() {
        table = new int[table.length * 2];
        for (int number = 0; number < size; number++) {
            int slot = hash(keys, number * words) & table.length - 1;
            while (table[slot] != 0) {
                slot = slot + 1 & table.length - 1;
            }
            table[slot] = number + 1;
        }
    }

    void get(int number, Packing packing, int[] into) {
        packing.unpack(keys, number * words, into);
    }

    /** How {@code number} is come to: from where, and what happens then; {@link Exploration#TICK} if time passes. */
    void reach(int number, int before, int by, int atTicks, int afterHappenings) {
        from[number] = before;
        label[number] = by;
        time[number] = atTicks;
        happenings[number] = afterHappenings;
    }

    int from(int number) {
        return from[number];
    }

    int label(int number) {
        return label[number];
    }

    int time(int number) {
        return time[number];
    }

    int happenings(int number) {
        return happenings[number];
    }
}
