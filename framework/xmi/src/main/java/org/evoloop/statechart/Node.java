package org.evoloop.statechart;

import java.util.ArrayList;
import java.util.Collections;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import org.evoloop.statechart.Vertex.ChartState;
import org.evoloop.statechart.Vertex.FinalState;
import org.evoloop.statechart.Vertex.Kind;
import org.evoloop.statechart.Vertex.Pseudostate;
import org.jspecify.annotations.Nullable;

/** A vertex, connected to its neighbors. Written only by {@link NetBuilder}. */
final class Node {
    /** How the events begin that SCXML raises when a state is done. */
    static final String DONE = "done.state.";

    final Vertex vertex;
    /** In document order, outer vertices before inner ones. */
    final int index;
    /** The region that contains it; for an entry or exit point, the region of its state. */
    final Zone zone;
    /** The state on whose border an entry or exit point stands. */
    final @Nullable Node border;

    /** Null unless it is a pseudostate. */
    private final @Nullable Kind kind;

    private final boolean state;
    // What is asked of a hundred thousand transitions' targets should be found without looking at the drawn state.
    private final List<String> entry;
    private final List<String> exit;
    private final List<String> activities;
    private final List<String> deferred;

    // Most vertices have nothing in most of these lists. Unlike List.of(), this empty list makes no iterators.

    List<Zone> zones = Collections.emptyList();
    /** In the order in which they are tried. */
    List<Link> outgoing = Collections.emptyList();
    /** Filled only for pseudostates; not needed for states. */
    List<Link> incoming = Collections.emptyList();

    private List<Link> completion = Collections.emptyList();
    /** Computed on first use, since it is rarely needed. */
    private @Nullable Map<String, List<Link>> byTrigger;

    /** Computed on first use. */
    private @Nullable String path;

    private boolean onlySimple = true;

    private boolean rivals;
    private int triggers;

    Node(Vertex vertex, int index, Zone zone, @Nullable Node border) {
        this.vertex = vertex;
        this.index = index;
        this.zone = zone;
        this.border = border;
        ChartState drawn = vertex instanceof ChartState some ? some : null;
        this.state = drawn != null;
        FinalState end = vertex instanceof FinalState some ? some : null;
        this.entry = drawn != null ? drawn.entry() : end != null ? end.entry() : List.of();
        this.exit = drawn != null ? drawn.exit() : end != null ? end.exit() : List.of();
        this.activities = drawn == null ? List.of() : drawn.doActivities();
        this.deferred = drawn == null ? List.of() : drawn.deferred();
        this.kind = vertex instanceof Pseudostate pseudostate ? pseudostate.kind() : null;
    }

    void add(Zone zone) {
        zones = with(zone, zones);
    }

    void addOutgoing(Link link) {
        outgoing = with(link, outgoing);
        onlySimple &= link.simple;
    }

    void addIncoming(Link link) {
        incoming = with(link, incoming);
    }

    private static <T> List<T> with(T another, List<T> some) {
        List<T> all = some.isEmpty() ? new ArrayList<>() : some;
        all.add(another);
        return all;
    }

    /**
     * Sorts its outgoing transitions.
     *
     * @param order in which they are tried
     * @param named the last vertex that used each trigger
     */
    void arrange(Comparator<Link> order, Map<String, Node> named) {
        // Simple ones are drawn in their order.
        if (!onlySimple) {
            outgoing.sort(order);
        }
        for (Link link : outgoing) {
            if (link.arc.triggers().isEmpty()) {
                rivals |= !completion.isEmpty();
                completion = with(link, completion);
            }
            List<String> all = link.arc.triggers();
            for (int i = 0; i < all.size(); i++) {
                rivals |= named.put(all.get(i), this) == this;
                triggers++;
            }
        }
    }

    /** Whether all its outgoing transitions are {@linkplain Link#simple simple}. */
    boolean hasOnlySimple() {
        return onlySimple;
    }

    /** Whether a trigger occurs twice on its transitions, or several of them have no trigger. */
    boolean hasRivals() {
        return rivals;
    }

    private Map<String, List<Link>> byTrigger() {
        if (byTrigger == null) {
            byTrigger = new LinkedHashMap<>();
            for (Link link : outgoing) {
                // A transition may name a trigger twice.
                for (String trigger : new LinkedHashSet<>(link.arc.triggers())) {
                    byTrigger
                            .computeIfAbsent(trigger, key -> new ArrayList<>(1))
                            .add(link);
                }
            }
        }
        return byTrigger;
    }

    /** The number of events for which it has transitions. */
    int triggerCount() {
        return rivals ? triggers().size() : triggers;
    }

    /** The events for which it has transitions. */
    Set<String> triggers() {
        return byTrigger().keySet();
    }

    /** Its transitions on an event, in the order in which they are tried. */
    List<Link> on(String trigger) {
        return byTrigger().getOrDefault(trigger, List.of());
    }

    /** Its transitions that wait for it to be complete, in the order in which they are tried. */
    List<Link> onCompletion() {
        return completion;
    }

    boolean isState() {
        return state;
    }

    boolean isFinal() {
        return vertex instanceof FinalState;
    }

    boolean isPseudostate() {
        return kind != null;
    }

    boolean is(Kind wanted) {
        return kind == wanted;
    }

    /** Whether a path of transitions goes on from it into several regions. */
    boolean isSplit() {
        return is(Kind.FORK) || (is(Kind.ENTRY_POINT) && outgoing.size() > 1);
    }

    boolean isHistory() {
        return is(Kind.SHALLOW_HISTORY) || is(Kind.DEEP_HISTORY);
    }

    /** Whether a path of transitions may end in it: a state, final state, history or terminate pseudostate. */
    boolean isTarget() {
        return !isPseudostate() || isHistory() || is(Kind.TERMINATE);
    }

    List<String> entry() {
        return entry;
    }

    List<String> exit() {
        return exit;
    }

    List<String> activities() {
        return activities;
    }

    /** The events deferred while it is active. */
    List<String> deferred() {
        return deferred;
    }

    /** Whether it is a parallel state of SCXML, even of one child. */
    boolean isParallel() {
        return !zones.isEmpty() && zones.get(0).ofParallel;
    }

    /** The event that SCXML raises when it is done. */
    String doneEvent() {
        return DONE + vertex.key();
    }

    /** Whether it has completion transitions. */
    boolean wantsCompletion() {
        return isState() && !completion.isEmpty();
    }

    /** Whether {@code other} is this vertex or inside it. */
    boolean holds(Node other) {
        Node inner = other;
        while (inner.zone.depth > zone.depth && inner.zone.owner != null) {
            inner = inner.zone.owner;
        }
        return inner == this;
    }

    /** {@code Outer.Inner}. */
    String path() {
        if (path == null) {
            Node outer = border == null ? zone.owner : border;
            path = outer == null ? simpleName() : outer.path() + "." + simpleName();
        }
        return path;
    }

    String simpleName() {
        if (!vertex.name().isEmpty()) {
            return vertex.name();
        }
        return isFinal() ? "final" : word();
    }

    /** The author's term for this kind of vertex. */
    String word() {
        if (kind != null) {
            return is(Kind.INITIAL)
                    ? "initial pseudostate"
                    : kind.name().toLowerCase(Locale.ROOT).replace('_', ' ');
        }
        return isState() ? "state" : "final state";
    }

    /** For messages: {@code state 'On.Idle'}. */
    @Override
    public String toString() {
        return word() + (vertex.name().isEmpty() ? "" : " '" + path() + "'");
    }
}
