package org.evoloop.statechart;

import java.util.List;

/** A state in which a machine can rest, and what happens there. Written by {@link Explorer} alone. */
final class Reached {
    /** In the order in which they were found; whoever knows more about one keeps it in an array. */
    final int index;

    final Snapshot snapshot;

    /** What each event does there, first those that are tried first. */
    List<Move> moves = List.of();

    Reached(int index, Snapshot snapshot) {
        this.index = index;
        this.snapshot = snapshot;
    }
}
