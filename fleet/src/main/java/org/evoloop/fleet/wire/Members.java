package org.evoloop.fleet.wire;

import java.util.Arrays;
import java.util.function.BiConsumer;
import org.jspecify.annotations.Nullable;

/**
 * The members of a JSON object, in two arrays: records have few, and a tree of nodes takes several times as long to build.
 * {@link JsonReader} says what their values are.
 */
final class Members {
    static final Object NULL = new Object();

    private static final int FEW = 8;

    private String[] names = new String[FEW];
    private Object[] values = new Object[FEW];
    private int count;

    void add(String name, Object value) {
        if (count == names.length) {
            names = Arrays.copyOf(names, 2 * count);
            values = Arrays.copyOf(values, 2 * count);
        }
        names[count] = name;
        values[count++] = value;
    }

    /** The last value of that name; null if there is none. */
    @Nullable
    Object get(String name) {
        for (int at = count - 1; at >= 0; at--) {
            if (names[at].equals(name)) {
                return values[at];
            }
        }
        return null;
    }

    void forEach(BiConsumer<String, Object> each) {
        for (int at = 0; at < count; at++) {
            each.accept(names[at], values[at]);
        }
    }
}
