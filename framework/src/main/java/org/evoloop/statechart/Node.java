package org.evoloop.statechart;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import org.evoloop.statechart.Vertex.ChartState;
import org.evoloop.statechart.Vertex.FinalState;
import org.evoloop.statechart.Vertex.Kind;
import org.evoloop.statechart.Vertex.Pseudostate;
import org.jspecify.annotations.Nullable;

/** A vertex with its neighbors. Written by {@link NetBuilder} alone. */
final class Node {
    final Vertex vertex;
    /** In document order, outer before inner. */
    final int index;
    /** The region that it stands in; of an entry or exit point the one of its state. */
    final Zone zone;
    /** The state on whose border an entry or exit point stands. */
    final @Nullable Node border;

    final List<Zone> zones = new ArrayList<>();
    final List<Link> outgoing = new ArrayList<>();
    final List<Link> incoming = new ArrayList<>();

    private final Map<String, List<Link>> byTrigger = new LinkedHashMap<>();
    private final List<Link> completion = new ArrayList<>();

    Node(Vertex vertex, int index, Zone zone, @Nullable Node border) {
        this.vertex = vertex;
        this.index = index;
        this.zone = zone;
        this.border = border;
    }

    /** Files a transition that leaves it under its triggers. */
    void index(Link link) {
        if (link.arc.triggers().isEmpty()) {
            completion.add(link);
        }
        for (String trigger : link.arc.triggers()) {
            List<Link> links = byTrigger.computeIfAbsent(trigger, key -> new ArrayList<>(1));
            // It may name the trigger twice.
            if (links.isEmpty() || links.get(links.size() - 1) != link) {
                links.add(link);
            }
        }
    }

    /** Whether several transitions that leave it have the same trigger, or several have none. */
    boolean hasRivals() {
        return completion.size() > 1 || byTrigger.values().stream().anyMatch(links -> links.size() > 1);
    }

    /** The events for which it has transitions. */
    Set<String> triggers() {
        return byTrigger.keySet();
    }

    /** Its transitions on an event, in the order in which they are tried. */
    List<Link> on(String trigger) {
        return byTrigger.getOrDefault(trigger, List.of());
    }

    /** Its transitions that wait for it to be complete, in the order in which they are tried. */
    List<Link> onCompletion() {
        return completion;
    }

    boolean isState() {
        return vertex instanceof ChartState;
    }

    boolean isFinal() {
        return vertex instanceof FinalState;
    }

    boolean is(Kind kind) {
        return vertex instanceof Pseudostate pseudostate && pseudostate.kind() == kind;
    }

    boolean isHistory() {
        return is(Kind.SHALLOW_HISTORY) || is(Kind.DEEP_HISTORY);
    }

    /** Whether a machine may rest in it or begin to rest in it. */
    boolean isTarget() {
        return !(vertex instanceof Pseudostate) || isHistory() || is(Kind.TERMINATE);
    }

    List<String> entry() {
        return vertex instanceof ChartState state ? state.entry() : List.of();
    }

    List<String> exit() {
        return vertex instanceof ChartState state ? state.exit() : List.of();
    }

    List<String> activities() {
        return vertex instanceof ChartState state ? state.doActivities() : List.of();
    }

    /** Whether transitions wait for it to be complete. */
    boolean wantsCompletion() {
        return isState() && !completion.isEmpty();
    }

    /** Whether {@code other} is this or stands in it. */
    boolean holds(Node other) {
        Node inner = other;
        while (inner.zone.depth > zone.depth && inner.zone.owner != null) {
            inner = inner.zone.owner;
        }
        return inner == this;
    }

    /** {@code Outer.Inner}. */
    String path() {
        StringBuilder path = new StringBuilder(simpleName());
        for (Node outer = border == null ? zone.owner : border; outer != null; outer = outer.zone.owner) {
            path.insert(0, outer.simpleName() + ".");
        }
        return path.toString();
    }

    String simpleName() {
        if (!vertex.name().isEmpty()) {
            return vertex.name();
        }
        return isFinal() ? "final" : word();
    }

    /** How its author calls such a vertex. */
    String word() {
        if (vertex instanceof Pseudostate pseudostate) {
            String kind = pseudostate.kind().name().toLowerCase(Locale.ROOT).replace('_', ' ');
            return is(Kind.INITIAL) ? "initial pseudostate" : kind;
        }
        return isState() ? "state" : "final state";
    }

    /** For messages: {@code state 'On.Idle'}. */
    @Override
    public String toString() {
        return word() + (vertex.name().isEmpty() ? "" : " '" + path() + "'");
    }
}
