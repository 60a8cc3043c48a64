package org.evoloop.engine;

import org.evoloop.migration.Mapping;
import org.evoloop.migration.Succession;

/**
 * Other models for a running converter, and how its state maps to them.
 *
 * <p>Threading: immutable.
 *
 * @param rules the converter's rules from then on
 * @since 0.1
 */
public record Swap(Rules rules, Succession succession) {

    /** A swap from {@code running} to {@code next}. */
    public static Swap of(Rules running, Rules next, Mapping mapping) {
        return new Swap(next, new Succession(running.table(), running.timers(), next.table(), next.timers(), mapping));
    }

    /** The name of the models in messages. */
    public String name() {
        return rules.table().models().evolved().name();
    }
}
