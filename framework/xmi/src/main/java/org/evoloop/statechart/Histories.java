package org.evoloop.statechart;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;

/** Merges states that differ only in what histories remember, if that never makes a difference. */
final class Histories {
    /** Enough for every machine drawn by hand. A machine that needs more rounds keeps all its states. */
    private static final int MAX_ROUNDS = 100;

    private final List<Reached> states;
    /** By the states' numbers. */
    private int[] blocks;

    private Histories(List<Reached> states) {
        this.states = states;
        this.blocks = new int[states.size()];
    }

    /** For each state, by number, its representative: another state or the state itself. */
    static List<Reached> merge(List<Reached> states) {
        for (Reached state : states) {
            if (state.snapshot.memory().length > 0) {
                return new Histories(states).merge();
            }
        }
        return states;
    }

    private record Appearance(List<Integer> leaves, List<Integer> done) {}

    private record Reaction(
            Cause cause,
            List<String> guards,
            List<String> effects,
            boolean still,
            Set<Node> left,
            boolean deferred,
            int target) {}

    private record Signature(int block, List<Reaction> reactions) {}

    private List<Reached> merge() {
        if (!refine()) {
            return states;
        }
        Map<Integer, Reached> first = new HashMap<>();
        states.stream()
                .sorted(Comparator.comparing(state -> state.snapshot))
                .forEach(state -> first.putIfAbsent(blocks[state.index], state));
        List<Reached> representatives = new ArrayList<>(states);
        representatives.replaceAll(state -> first.getOrDefault(blocks[state.index], state));
        return representatives;
    }

    /** Partition refinement: splits sets of states that look alike until all states of a set react alike. */
    private boolean refine() {
        Map<Appearance, Integer> looks = new HashMap<>();
        for (Reached state : states) {
            Appearance look = new Appearance(list(state.snapshot.leaves()), list(state.snapshot.done()));
            blocks[state.index] = looks.computeIfAbsent(look, key -> looks.size());
        }
        int count = looks.size();
        for (int round = 0; round < MAX_ROUNDS; round++) {
            Map<Signature, Integer> signatures = new HashMap<>();
            int[] next = new int[blocks.length];
            for (Reached state : states) {
                Signature signature = new Signature(blocks[state.index], reactions(state.moves));
                next[state.index] = signatures.computeIfAbsent(signature, key -> signatures.size());
            }
            blocks = next;
            if (signatures.size() == count) {
                return true;
            }
            count = signatures.size();
        }
        return false;
    }

    private List<Reaction> reactions(List<Move> moves) {
        List<Reaction> reactions = new ArrayList<>();
        for (Move move : moves) {
            reactions.add(new Reaction(
                    move.cause(),
                    move.guards(),
                    move.effects(),
                    move.still(),
                    move.left(),
                    move.deferred(),
                    blocks[move.target()]));
        }
        return reactions;
    }

    private static List<Integer> list(int[] numbers) {
        return Arrays.stream(numbers).boxed().toList();
    }
}
