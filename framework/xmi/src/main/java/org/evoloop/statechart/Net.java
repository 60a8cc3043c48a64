package org.evoloop.statechart;

import java.util.List;
import java.util.Set;

/**
 * A statechart whose vertices are connected to each other.
 *
 * @param tops its top regions
 * @param nodes in document order
 * @param triggers the events on transitions
 * @param timeTriggers the timer events
 * @param spontaneous the events drawn as raised by the device itself
 * @param urgent the events drawn as urgent
 * @param raised the events that the machine raises itself, so that nobody else does: {@code done.state.KEY}
 * @param isCalm whether no timers and no do activities run while the machine is stable
 */
record Net(
        Statechart chart,
        List<Zone> tops,
        List<Node> nodes,
        Set<String> triggers,
        Set<String> timeTriggers,
        Set<String> spontaneous,
        Set<String> urgent,
        Set<String> raised,
        boolean isCalm) {
    /** Whether it follows SCXML, otherwise UML. */
    boolean isScxml() {
        return chart.semantics() == Statechart.Semantics.SCXML;
    }

    /** Whether the machine raises an event itself. */
    boolean isRaised(String trigger) {
        return !raised.isEmpty() && raised.contains(trigger);
    }

    /** Whether an event is raised by a timer. */
    boolean isTime(String trigger) {
        return !timeTriggers.isEmpty() && timeTriggers.contains(trigger);
    }

    /** Whether no state contains others, and there is nothing beside them. */
    boolean isOneRegion() {
        return tops.size() == 1 && tops.get(0).nodes.size() == nodes.size();
    }

    Node node(int index) {
        return nodes.get(index);
    }
}
