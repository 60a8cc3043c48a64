package org.evoloop.fleet.device;

import org.evoloop.core.Rules;
import org.evoloop.core.Swap;
import org.evoloop.migration.Mapping;

/**
 * A pair of models under a name that means the same for good.
 *
 * <p>Threading: immutable.
 *
 * @param version what devices call it
 * @since 0.1
 */
public record Model(String version, Rules rules) {

    /** How another one takes over from this one. */
    public Takeover to(Model next, Mapping mapping) {
        return new Takeover(next, Swap.of(rules, next.rules, mapping));
    }

    /** Another pair, and what becomes in it of what is known. */
    public record Takeover(Model next, Swap swap) {}
}
