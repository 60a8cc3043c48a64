package org.evoloop.benchmarks.decision;

/**
 * A machine of one library, following its walk. Every transition that is actually taken counts one action.
 *
 * <p>Threading: one thread.
 */
abstract class Walker {
    private long actions;

    /** Makes the machine handle the event with this name. */
    abstract void fire(String event);

    /** The action of every transition. */
    final void act() {
        actions++;
    }

    final long actions() {
        return actions;
    }
}
