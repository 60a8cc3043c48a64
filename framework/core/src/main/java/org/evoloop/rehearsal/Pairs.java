package org.evoloop.rehearsal;

import java.util.HashMap;
import java.util.HashSet;
import java.util.Map;
import java.util.Set;
import org.evoloop.engine.Core;
import org.evoloop.engine.Pending;
import org.evoloop.engine.Snapshot;
import org.jspecify.annotations.Nullable;

/** The occurrences of a converter, by number, with the numbers that other models have for them. */
final class Pairs {
    private final Map<Long, Long> there = new HashMap<>();
    private final Map<Long, Long> back = new HashMap<>();

    void clear() {
        there.clear();
        back.clear();
    }

    void add(long number, long others) {
        there.put(number, others);
        back.put(others, number);
    }

    /** Forgets an occurrence of the converter; returns the other models' number, null if they had none. */
    @Nullable
    Long remove(long number) {
        Long others = there.remove(number);
        if (others != null) {
            back.remove(others);
        }
        return others;
    }

    /** The other models' number for an occurrence of the converter; null if they have none. */
    @Nullable
    Long others(long number) {
        return there.get(number);
    }

    /** The converter's number for an occurrence of the other models; null if it has none. */
    @Nullable
    Long converters(long others) {
        return back.get(others);
    }

    /** The converter's occurrences. */
    Set<Long> all() {
        return new HashSet<>(there.keySet());
    }

    /** The occurrences of a core that have not ended. */
    static Set<Long> open(Core core) {
        Snapshot now = core.snapshot();
        Set<Long> numbers = new HashSet<>();
        for (Pending pending : now.waiting()) {
            numbers.add(pending.number());
        }
        if (now.work() != null) {
            numbers.add(now.work().pending().number());
        }
        return numbers;
    }
}
