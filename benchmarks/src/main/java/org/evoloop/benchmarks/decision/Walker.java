package org.evoloop.benchmarks.decision;

/**
 * A machine of one library on its way. Every transition that is really taken counts one action.
 *
 * <p>Threading: one thread.
 */
abstract class Walker {
    private long actions;

    /** Has the machine take the event of this name. */
    abstract void fire(String event);

    /** What a transition does. */
    final void act() {
        actions++;
    }

    final long actions() {
        return actions;
    }
}
