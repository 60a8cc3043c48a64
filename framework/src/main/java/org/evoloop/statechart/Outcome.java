package org.evoloop.statechart;

import java.util.List;
import java.util.Set;

/**
 * What one run to completion did.
 *
 * @param target where the machine rests now
 * @param effects the behaviors that ran, in order
 * @param left the states that were left, even if they were entered again
 * @param still whether no state was left or entered
 * @param used the transitions that were taken
 */
record Outcome(Snapshot target, List<String> effects, Set<Node> left, boolean still, Set<Link> used) {}
