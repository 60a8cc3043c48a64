package org.evoloop.statechart;

import java.util.ArrayList;
import java.util.List;
import org.jspecify.annotations.Nullable;

/**
 * A shortcut for the most common transitions: without a guard, from one simple state to another in the same region,
 * with nothing else affected. A {@link RunToCompletion} gives the same result.
 */
final class PlainSteps {
    private PlainSteps() {}

    /** The active vertex, if it is the only one and has no enclosing state, and nothing else matters; else null. */
    static @Nullable Node alone(Net net, StableConfiguration state) {
        if (!state.isOneState() || net.tops().size() > 1) {
            return null;
        }
        Node node = net.node(state.leaves()[0]);
        return node.zone.owner == null ? node : null;
    }

    /** Whether the transition only leaves one state and enters another. */
    static boolean isPlain(Link link) {
        Node target = link.target;
        return link.simple && target.zones.isEmpty() && !target.wantsCompletion();
    }

    /**
     * The only transition of {@code node} on an event, if it only leaves one state and enters another, whatever is
     * around and beside them; else null.
     *
     * @param node the only active vertex with transitions on the event
     */
    static @Nullable Link only(Node node, String trigger, StableConfiguration state) {
        List<Link> links = node.on(trigger);
        return links.size() == 1 && node.zones.isEmpty() && state.done().length == 0 && isPlain(links.get(0))
                ? links.get(0)
                : null;
    }

    /** The behaviors that run in such a step, in order. */
    static List<String> effects(Link link) {
        return effects(link.source.exit(), link.arc.effects(), link.target.entry());
    }

    /** All of these, in this order; most transitions have none. */
    static List<String> effects(List<String> exit, List<String> own, List<String> entry) {
        if (exit.isEmpty() && own.isEmpty() && entry.isEmpty()) {
            return List.of();
        }
        List<String> effects = new ArrayList<>(exit);
        effects.addAll(own);
        effects.addAll(entry);
        return List.copyOf(effects);
    }
}
