package org.evoloop.statechart;

import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import org.jspecify.annotations.Nullable;

/**
 * What happens where hardly anything can: one transition without guard leads from one simple state to another beside it,
 * and nothing else is active. A {@link Step} comes to the same; most transitions of most charts are of this kind.
 */
final class PlainSteps {
    private final Net net;
    private final @Nullable Snapshot[] resting;

    PlainSteps(Net net) {
        this.net = net;
        this.resting = new Snapshot[net.nodes().size()];
    }

    /** Whether a machine rests in a state with nothing around it or beside it, and that is all that matters. */
    static boolean isAlone(Net net, Snapshot state) {
        return state.isOneState() && net.tops().size() == 1 && net.node(state.leaves()[0]).zone.owner == null;
    }

    /** What a cause does to a machine that rests; null if that takes a {@link Step} to find out. */
    @Nullable
    Outcome react(Snapshot before, Cause cause) {
        if (cause.kind() == Cause.Kind.COMPLETION || !isAlone(net, before)) {
            return null;
        }
        Node source = net.node(before.leaves()[0]);
        List<Link> links = source.on(cause.name());
        if (links.size() != 1) {
            return null;
        }
        Link link = links.get(0);
        Node target = link.target;
        boolean plain = target.isState()
                && target.zone == source.zone
                && target.zones.isEmpty()
                && !target.wantsCompletion()
                && link.arc.kind() == Arc.Kind.EXTERNAL
                && link.arc.guard().isEmpty();
        return plain
                ? new Outcome(restingIn(target), effects(link), Set.of(source), Set.of(target), Set.of(link))
                : null;
    }

    private Snapshot restingIn(Node state) {
        Snapshot known = resting[state.index];
        if (known == null) {
            known = Snapshot.of(state);
            resting[state.index] = known;
        }
        return known;
    }

    private static List<String> effects(Link link) {
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
