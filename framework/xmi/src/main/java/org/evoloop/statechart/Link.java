package org.evoloop.statechart;

/** An arc with its ends. */
final class Link {
    static final String ELSE = "else";

    /** In the order in which they are drawn. */
    final int index;

    final Arc arc;
    final Node source;
    final Node target;

    Link(int index, Arc arc, Node source, Node target) {
        this.index = index;
        this.arc = arc;
        this.source = source;
        this.target = target;
    }

    /** Whether it leaves nothing; a local one from a state without regions to itself has nothing to leave. */
    boolean isInternal() {
        return arc.kind() == Arc.Kind.INTERNAL || (isLocalLoop() && source.zones.isEmpty());
    }

    /** Whether it leaves and enters what is in its state, and not the state. */
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

    /** Of transitions that one event enables the guarded ones come first, the one for the rest comes last. */
    int rank() {
        if (arc.guard().isEmpty() && !target.isPseudostate()) {
            return 1;
        }
        if (isElse()) {
            return 2;
        }
        return isGuarded() || depends() ? 0 : 1;
    }

    /** Whether what comes behind it decides whether it can be taken. */
    private boolean depends() {
        return target.is(Vertex.Kind.JOIN)
                || ((target.is(Vertex.Kind.JUNCTION) || target.is(Vertex.Kind.CHOICE))
                        && target.outgoing.stream()
                                .noneMatch(link -> link.arc.guard().isEmpty()));
    }

    /**
     * The region in which everything changes when it is taken; null for the whole machine. A border point is left and
     * entered with its state, but an entry point leads into its state.
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
