package org.evoloop.statechart;

import java.util.List;
import java.util.Set;

/**
 * A statechart whose vertices know their neighbors.
 *
 * @param tops its top regions
 * @param nodes in document order
 * @param triggers the events on transitions
 * @param timeTriggers the timer events
 * @param spontaneous the events that are drawn as the device's own
 * @param isCalm whether nothing is active while the machine rests: no timers and no do activities
 */
record Net(
        Statechart chart,
        List<Zone> tops,
        List<Node> nodes,
        Set<String> triggers,
        Set<String> timeTriggers,
        Set<String> spontaneous,
        boolean isCalm) {
    /** Whether an event is raised by itself. */
    boolean isTime(String trigger) {
        return !timeTriggers.isEmpty() && timeTriggers.contains(trigger);
    }

    Node node(int index) {
        return nodes.get(index);
    }
}
