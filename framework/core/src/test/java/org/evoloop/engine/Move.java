package org.evoloop.engine;

import org.jspecify.annotations.Nullable;

/**
 * Something that can happen.
 *
 * @param what a description for people
 * @param input the core's input; null if the core does not notice
 * @param world the core's surroundings afterwards
 */
record Move(String what, @Nullable Input input, World world) {
    static Move unnoticed(String what, World world) {
        return new Move(what, null, world);
    }

    static Move noticed(Input input, World world) {
        return new Move(input.toString(), input, world);
    }
}
