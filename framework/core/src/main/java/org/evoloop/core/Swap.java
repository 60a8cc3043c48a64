package org.evoloop.core;

import org.evoloop.migration.Mapping;
import org.evoloop.migration.Succession;

/**
 * Other models for a converter that runs, and what becomes in them of what it knows.
 *
 * <p>Threading: immutable.
 *
 * @param rules by which it goes from then on
 * @since 0.1
 */
public record Swap(Rules rules, Succession succession) {

    /** A swap from {@code running} to {@code next}. */
    public static Swap of(Rules running, Rules next, Mapping mapping) {
        return new Swap(next, new Succession(running.table(), running.timers(), next.table(), next.timers(), mapping));
    }

    /** What messages call the models. */
    public String name() {
        return rules.table().models().evolved().name();
    }
}
