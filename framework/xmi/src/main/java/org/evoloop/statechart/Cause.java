package org.evoloop.statechart;

import org.jspecify.annotations.Nullable;

/**
 * What makes a machine that rests move.
 *
 * @param name of the event as drawn; empty for a completion
 * @param owner the state whose timer elapses or whose do activity ends; null for other events
 */
record Cause(Kind kind, String name, @Nullable Node owner) {
    enum Kind {
        EVENT,
        TIME,
        COMPLETION
    }
}
