package org.evoloop.statechart;

import org.jspecify.annotations.Nullable;

/** What happens from one event until the machine is stable again, for given values of the guards. Used once. */
interface RunToCompletion {
    /** A step by the standard that the chart follows. */
    static RunToCompletion of(Net net, GuardCases guards) {
        return net.isScxml() ? new ScxmlStep(net, guards) : new UmlStep(net, guards);
    }

    /** Starts the machine. */
    StepResult start();

    /** Enters a state, whether or not a transition leads there. */
    StepResult startIn(Node state);

    /** Handles a cause in a stable machine; returns null if nothing happens. */
    @Nullable
    StepResult react(StableConfiguration before, Cause cause);

    /** Whether the event, to which nothing reacted, is deferred. */
    boolean isDeferring();
}
