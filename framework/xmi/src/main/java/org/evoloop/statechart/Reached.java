package org.evoloop.statechart;

import java.util.List;

/** A stable state of a machine, and what happens there. Written only by {@link Explorer}. */
final class Reached {
    /** In the order of discovery; other classes use it as an array index. */
    final int index;

    final StableConfiguration snapshot;

    /** The moves for each event, in the order in which they are tried. */
    List<Move> moves = List.of();

    Reached(int index, StableConfiguration snapshot) {
        this.index = index;
        this.snapshot = snapshot;
    }
}
