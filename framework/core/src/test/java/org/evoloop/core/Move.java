package org.evoloop.core;

import org.jspecify.annotations.Nullable;

/**
 * One thing that can happen.
 *
 * @param what for people
 * @param input what the core is told; null if it does not notice
 * @param world how things stand afterwards around the core
 */
record Move(String what, @Nullable Input input, World world) {
    static Move unnoticed(String what, World world) {
        return new Move(what, null, world);
    }

    static Move told(Input input, World world) {
        return new Move(input.toString(), input, world);
    }
}
