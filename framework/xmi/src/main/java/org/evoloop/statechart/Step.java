package org.evoloop.statechart;

import org.jspecify.annotations.Nullable;

/** What happens from one event until the machine is stable again, for given values of the guards. Used once. */
interface Step {
    /** A step by the standard that the chart follows. */
    static Step of(Net net, Guards guards) {
        return net.isScxml() ? new ScxmlStep(net, guards) : new UmlStep(net, guards);
    }

    /** Starts the machine. */
    Outcome start();

    /** Enters a state, whether or not a transition leads there. */
    Outcome startIn(Node state);

    /** Handles a cause in a stable machine; returns null if nothing happens. */
    @Nullable
    Outcome react(Snapshot before, Cause cause);

    /** Whether the event, to which nothing reacted, is deferred. */
    boolean isDeferring();
}
