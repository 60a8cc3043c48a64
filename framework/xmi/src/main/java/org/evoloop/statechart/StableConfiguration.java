package org.evoloop.statechart;

import java.util.Arrays;

/** Everything that determines how a stable machine reacts to events. */
final class StableConfiguration implements Comparable<StableConfiguration> {
    private static final int[] NONE = {};

    /** The innermost active vertex of each region, in document order; or the terminate pseudostate. */
    private final int[] leaves;
    /** For each region with a memory: its index, the number of vertices, and the vertices. */
    private final int[] memory;
    /** The states whose do activities have ended. */
    private final int[] done;

    private final int hash;

    StableConfiguration(int[] leaves, int[] memory, int[] done) {
        this.leaves = leaves;
        this.memory = memory;
        this.done = done;
        this.hash = (Arrays.hashCode(leaves) * 31 + Arrays.hashCode(memory)) * 31 + Arrays.hashCode(done);
    }

    /** A snapshot in which the machine is in one simple state and nothing else matters. */
    static StableConfiguration of(Node state) {
        return new StableConfiguration(new int[] {state.index}, NONE, NONE);
    }

    /** Whether only one active vertex matters. */
    boolean isOneState() {
        return leaves.length == 1 && memory.length == 0 && done.length == 0;
    }

    /** A copy in which {@code after} replaces {@code before}. */
    StableConfiguration with(Node before, Node after) {
        int[] changed = leaves.clone();
        for (int i = 0; i < changed.length; i++) {
            if (changed[i] == before.index) {
                changed[i] = after.index;
            }
        }
        return new StableConfiguration(changed, memory, done);
    }

    int[] leaves() {
        return leaves;
    }

    int[] memory() {
        return memory;
    }

    int[] done() {
        return done;
    }

    /** Whether they differ at most in what is remembered. */
    boolean looksLike(StableConfiguration other) {
        return Arrays.equals(leaves, other.leaves) && Arrays.equals(done, other.done);
    }

    @Override
    public boolean equals(Object object) {
        return object instanceof StableConfiguration other && looksLike(other) && Arrays.equals(memory, other.memory);
    }

    @Override
    public int hashCode() {
        return hash;
    }

    /** Document order; a snapshot that remembers less comes first. */
    @Override
    public int compareTo(StableConfiguration other) {
        int byLeaves = Arrays.compare(leaves, other.leaves);
        int byDone = byLeaves != 0 ? byLeaves : Arrays.compare(done, other.done);
        return byDone != 0 ? byDone : Arrays.compare(memory, other.memory);
    }
}
