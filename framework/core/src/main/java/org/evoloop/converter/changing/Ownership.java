package org.evoloop.converter.changing;

import java.util.ArrayList;
import java.util.Collections;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.WeakHashMap;
import org.jspecify.annotations.Nullable;

/**
 * What one converter owns and no other may use: its components and its clock until it is closed, its knowledge for
 * good, since that has left its initial states.
 *
 * <p>Threading: thread-safe.
 */
final class Ownership {
    /** The names of the converters. */
    private static final Map<Object, String> OWNERS = new WeakHashMap<>();

    private final String converter;
    private final Set<Object> own = Collections.newSetFromMap(new IdentityHashMap<>());

    Ownership(String converter) {
        this.converter = converter;
    }

    /**
     * Takes {@code thing}.
     *
     * @throws IllegalStateException if a converter owns it already
     */
    void take(Object thing, String name) {
        List<String> problems = new ArrayList<>();
        take(thing, name, "make another one", problems);
        if (!problems.isEmpty()) {
            throw new IllegalStateException(problems.get(0));
        }
    }

    /** Takes {@code thing}, or adds to {@code problems} that it belongs to a converter already. */
    void take(Object thing, String name, String remedy, List<String> problems) {
        synchronized (OWNERS) {
            @Nullable String owner = OWNERS.putIfAbsent(thing, converter);
            if (owner == null) {
                own.add(thing);
            } else {
                problems.add(name + " belongs to the converter " + owner + " already; " + remedy);
            }
        }
    }

    void giveBack(Object thing) {
        synchronized (OWNERS) {
            if (own.remove(thing)) {
                OWNERS.remove(thing);
            }
        }
    }

    /** @param kept what this converter still owns afterwards; null for nothing */
    void giveBackAll(@Nullable Object kept) {
        synchronized (OWNERS) {
            for (Object thing : own) {
                if (thing != kept) {
                    OWNERS.remove(thing);
                }
            }
            own.clear();
        }
    }
}
