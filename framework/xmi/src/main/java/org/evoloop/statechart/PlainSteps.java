package org.evoloop.statechart;

import java.util.ArrayList;
import java.util.List;
import org.jspecify.annotations.Nullable;

/**
 * What happens where hardly anything can: one transition without guard leads from one simple state to another beside
 * it, and nothing else is active. A {@link Step} comes to the same; most transitions of most charts are of this kind.
 */
final class PlainSteps {
    private PlainSteps() {}

    /**
     * The vertex in which a machine rests with nothing around it or beside it, if that is all that matters; else null.
     */
    static @Nullable Node alone(Net net, Snapshot state) {
        if (!state.isOneState() || net.tops().size() > 1) {
            return null;
        }
        Node node = net.node(state.leaves()[0]);
        return node.zone.owner == null ? node : null;
    }

    /** Whether nothing happens but that the one state is left and the other entered. */
    static boolean isPlain(Link link) {
        Node target = link.target;
        return target.isState()
                && target.zone == link.source.zone
                && target.zones.isEmpty()
                && !target.wantsCompletion()
                && link.arc.kind() == Arc.Kind.EXTERNAL
                && link.arc.guard().isEmpty();
    }

    /**
     * The only transition of {@code node} on an event if nothing happens but that the one state is left and the other
     * entered, whatever stands around and beside it; else null.
     *
     * @param node the only active vertex with transitions on the event
     */
    static @Nullable Link only(Node node, String trigger, Snapshot state) {
        List<Link> links = node.on(trigger);
        return links.size() == 1 && node.zones.isEmpty() && state.done().length == 0 && isPlain(links.get(0))
                ? links.get(0)
                : null;
    }

    /** The behaviors that run then, in order. */
    static List<String> effects(Link link) {
        List<String> exit = link.source.exit();
        List<String> own = link.arc.effects();
        List<String> entry = link.target.entry();
        if (exit.isEmpty() && own.isEmpty() && entry.isEmpty()) {
            return List.of();
        }
        List<String> effects = new ArrayList<>(exit);
        effects.addAll(own);
        effects.addAll(entry);
        return List.copyOf(effects);
    }
}
