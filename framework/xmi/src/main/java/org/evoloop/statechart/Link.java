package org.evoloop.statechart;

/** An arc, connected to its vertices. */
final class Link {
    static final String ELSE = "else";

    final Arc arc;
    final Node source;
    final Node target;

    /**
     * Whether it leads from a state to a state of the same region, without a guard or a keyword, and leaves only that. Most transitions do,
     * and since few rules apply to them, neither end needs to be examined again.
     */
    final boolean simple;

    Link(Arc arc, Node source, Node target) {
        this.arc = arc;
        this.source = source;
        this.target = target;
        this.simple = source.isState()
                && target.isState()
                && source.zone == target.zone
                && !source.zone.ofParallel
                && arc.kind() == Arc.Kind.EXTERNAL
                && arc.guard().isEmpty();
    }

    /** Whether it leaves no state. That includes a local transition from a state without regions to itself. */
    boolean isInternal() {
        return arc.kind() == Arc.Kind.INTERNAL || (isLocalLoop() && source.zones.isEmpty());
    }

    /** Whether it leaves and enters the contents of its state, but not the state itself. */
    boolean isLocalLoop() {
        return isLocal() && source == target && source.isState();
    }

    private boolean isLocal() {
        return arc.kind() == Arc.Kind.LOCAL;
    }

    boolean isElse() {
        return arc.guard().equals(ELSE);
    }

    boolean isGuarded() {
        return !arc.guard().isEmpty() && !isElse();
    }

    /**
     * The order in which the transitions enabled by one event are tried: guarded ones first, the {@code [else]} branch
     * last.
     */
    int rank() {
        if (arc.guard().isEmpty() && !target.isPseudostate()) {
            return 1;
        }
        if (isElse()) {
            return 2;
        }
        return isGuarded() || depends() ? 0 : 1;
    }

    /** Whether the branches after its target decide if it can be taken. */
    private boolean depends() {
        return target.is(Vertex.Kind.JOIN)
                || ((target.is(Vertex.Kind.JUNCTION) || target.is(Vertex.Kind.CHOICE))
                        && target.outgoing.stream()
                                .noneMatch(link -> link.arc.guard().isEmpty()));
    }

    /**
     * The innermost region that contains everything it changes; null for the whole machine. Entry and exit points are
     * left and entered with their state, but the transition from an entry point leads into that state.
     */
    @org.jspecify.annotations.Nullable
    Zone domain() {
        if (isLocal()) {
            for (Zone inner : target.zones) {
                if (within(inner, source)) {
                    return inner;
                }
            }
        }
        if (source.is(Vertex.Kind.ENTRY_POINT) || isLocal()) {
            Node outer = source.border == null ? source : source.border;
            for (Zone inner : outer.zones) {
                if (target != outer && inner.depth <= target.zone.depth && within(inner, target)) {
                    return inner;
                }
            }
        }
        if (target.is(Vertex.Kind.EXIT_POINT) && target.border != null && target.border != source) {
            for (Zone inner : target.border.zones) {
                if (within(inner, source)) {
                    return inner;
                }
            }
        }
        return Zone.common(source.zone, target.zone);
    }

    private static boolean within(Zone zone, Node node) {
        return Zone.common(zone, node.zone) == zone;
    }

    /** For messages: {@code transition from state 'A' to state 'B' on 'e' [g] (line 12, id t)}. */
    @Override
    public String toString() {
        String triggers = arc.triggers().isEmpty() ? "" : " on '" + String.join("', '", arc.triggers()) + "'";
        String guard = arc.guard().isEmpty() ? "" : " [" + arc.guard() + "]";
        String place = arc.place().equals(Place.NONE) ? "" : " (" + arc.place() + ")";
        return "transition from " + source + " to " + target + triggers + guard + place;
    }
}
