package org.evoloop.fleet.device;

import org.evoloop.engine.Rules;
import org.evoloop.engine.Swap;
import org.evoloop.migration.Mapping;

/**
 * A pair of models under a permanent name.
 *
 * <p>Threading: immutable.
 *
 * @param version its name
 * @since 0.1
 */
public record Model(String version, Rules rules) {

    /** The switch from this pair to another. */
    public Takeover to(Model next, Mapping mapping) {
        return new Takeover(next, Swap.of(rules, next.rules, mapping));
    }

    /** Another pair, and how the state maps to it. */
    public record Takeover(Model next, Swap swap) {}
}
