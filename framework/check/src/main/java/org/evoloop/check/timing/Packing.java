package org.evoloop.check.timing;

import java.util.Arrays;
import java.util.List;

/** Packs small numbers into as few words as possible, and unpacks them. */
final class Packing {
    private final int[] word;
    private final int[] shift;
    private final long[] mask;
    private final int words;

    /** @param largest of each number; none is less than 0 */
    Packing(List<Integer> largest) {
        int fields = largest.size();
        word = new int[fields];
        shift = new int[fields];
        mask = new long[fields];
        int used = 0;
        int filled = 0;
        for (int field = 0; field < fields; field++) {
            int bits = Math.max(1, Integer.SIZE - Integer.numberOfLeadingZeros(largest.get(field)));
            if (filled + bits > Long.SIZE) {
                used++;
                filled = 0;
            }
            word[field] = used;
            shift[field] = filled;
            mask[field] = (1L << bits) - 1;
            filled += bits;
        }
        words = used + 1;
    }

    int words() {
        return words;
    }

    void pack(int[] numbers, long[] into) {
        Arrays.fill(into, 0);
        for (int field = 0; field < numbers.length; field++) {
            into[word[field]] |= (long) numbers[field] << shift[field];
        }
    }

    void unpack(long[] from, int offset, int[] into) {
        for (int field = 0; field < into.length; field++) {
            into[field] = (int) (from[offset + word[field]] >>> shift[field] & mask[field]);
        }
    }
}
