package org.evoloop.statechart;

import java.util.ArrayList;
import java.util.List;
import org.jspecify.annotations.Nullable;

/** A region, connected to its neighbors. Written only by {@link NetBuilder}. */
final class Zone {
    final Region region;
    /** The state that it belongs to; null for a top region. */
    final @Nullable Node owner;
    /** The number of enclosing regions. */
    final int depth;
    /** In document order, outer regions before inner ones. */
    final int index;
    /** Whether it is the region of one child of a parallel state of SCXML, which is its only state. */
    final boolean ofParallel;

    final List<Node> nodes = new ArrayList<>();

    @Nullable
    Node initial;

    boolean hasHistory;

    Zone(Region region, @Nullable Node owner, int index, boolean ofParallel) {
        this.region = region;
        this.owner = owner;
        this.depth = owner == null ? 0 : owner.zone.depth + 1;
        this.index = index;
        this.ofParallel = ofParallel;
    }

    /**
     * The innermost region that contains both; null, which means the machine itself, if they are in different top
     * regions.
     */
    static @Nullable Zone common(Zone one, Zone other) {
        Zone a = one;
        Zone b = other;
        while (a != b) {
            Node outer = a.depth >= b.depth ? a.owner : b.owner;
            if (outer == null) {
                return null;
            }
            if (a.depth >= b.depth) {
                a = outer.zone;
            } else {
                b = outer.zone;
            }
        }
        return a;
    }

    /** For messages. */
    @Override
    public String toString() {
        String name = region.name().isEmpty() ? "region" : "region '" + region.name() + "'";
        return owner == null ? "the machine" : owner.zones.size() == 1 ? owner.toString() : name + " of " + owner;
    }
}
