package org.evoloop.device;

import org.evoloop.evolution.Values;

/**
 * What a function or an effect of a device file does outside of the converter.
 *
 * <p>Threading: called by one thread at a time of those that run functions and effects.
 *
 * @since 0.1
 */
@FunctionalInterface
public interface Outward {
    /**
     * Does it.
     *
     * @param values of the event
     * @throws Exception any failure: it is reported, and nothing follows from it
     */
    void perform(Values values) throws Exception;
}
