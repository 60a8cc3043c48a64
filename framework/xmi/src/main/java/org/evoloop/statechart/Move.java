package org.evoloop.statechart;

import java.util.List;
import java.util.Set;

/**
 * What an event does if its guards hold and those of earlier moves do not.
 *
 * @param target the number of the stable state reached
 * @param effects the behaviors that run, in order
 * @param still whether nothing is left or entered
 * @param left the states that are left, even if they are entered again
 * @param deferred whether nothing happens and the event waits
 */
record Move(
        Cause cause,
        List<String> guards,
        int target,
        List<String> effects,
        boolean still,
        Set<Node> left,
        boolean deferred) {}
