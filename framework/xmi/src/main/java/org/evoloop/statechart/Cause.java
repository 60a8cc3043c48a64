package org.evoloop.statechart;

import org.jspecify.annotations.Nullable;

/**
 * What triggers a step of a stable machine.
 *
 * @param name the event's name as drawn; empty for a completion
 * @param owner the state whose timer elapses or whose do activity ends; null for other events
 */
record Cause(Kind kind, String name, @Nullable Node owner) {
    enum Kind {
        EVENT,
        TIME,
        COMPLETION
    }
}
