package org.evoloop.statechart;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;

/** Finds states that differ in what is remembered only, where that will never matter. */
final class Histories {
    /** Enough for every machine that a person draws; a machine that needs more keeps all its states. */
    private static final int MAX_ROUNDS = 100;

    private final Map<Snapshot, List<Explorer.Move>> moves;
    private Map<Snapshot, Integer> blocks = new HashMap<>();

    private Histories(Map<Snapshot, List<Explorer.Move>> moves) {
        this.moves = moves;
    }

    /** For each state for which another one stands that one, and perhaps for others themselves. */
    static Map<Snapshot, Snapshot> merge(Map<Snapshot, List<Explorer.Move>> moves) {
        return new Histories(moves).merge();
    }

    private record Appearance(List<Integer> leaves, List<Integer> done) {}

    private record Reaction(
            Cause cause, List<String> guards, List<String> effects, boolean still, Set<Node> left, int target) {}

    private record Signature(int block, List<Reaction> reactions) {}

    private Map<Snapshot, Snapshot> merge() {
        Map<Snapshot, Snapshot> representatives = new HashMap<>();
        if (moves.keySet().stream().allMatch(state -> state.memory().length == 0)) {
            return representatives;
        }
        boolean stable = refine();
        Map<Integer, Snapshot> first = new HashMap<>();
        moves.keySet().stream().sorted().forEach(state -> {
            Snapshot one = stable ? first.computeIfAbsent(blocks.getOrDefault(state, 0), block -> state) : state;
            representatives.put(state, one);
        });
        return representatives;
    }

    /** Splits sets of states that look alike until the states of each react alike. */
    private boolean refine() {
        Map<Appearance, Integer> looks = new HashMap<>();
        for (Snapshot state : moves.keySet()) {
            Appearance look = new Appearance(list(state.leaves()), list(state.done()));
            blocks.put(state, looks.computeIfAbsent(look, key -> looks.size()));
        }
        int count = looks.size();
        for (int round = 0; round < MAX_ROUNDS; round++) {
            Map<Signature, Integer> signatures = new HashMap<>();
            Map<Snapshot, Integer> next = new HashMap<>();
            for (Map.Entry<Snapshot, List<Explorer.Move>> entry : moves.entrySet()) {
                Signature signature = new Signature(block(entry.getKey()), reactions(entry.getValue()));
                next.put(entry.getKey(), signatures.computeIfAbsent(signature, key -> signatures.size()));
            }
            blocks = next;
            if (signatures.size() == count) {
                return true;
            }
            count = signatures.size();
        }
        return false;
    }

    private List<Reaction> reactions(List<Explorer.Move> row) {
        List<Reaction> reactions = new ArrayList<>();
        for (Explorer.Move move : row) {
            Outcome outcome = move.outcome();
            reactions.add(new Reaction(
                    move.cause(),
                    move.guards(),
                    outcome.effects(),
                    outcome.still(),
                    outcome.left(),
                    block(outcome.target())));
        }
        return reactions;
    }

    private int block(Snapshot state) {
        return blocks.getOrDefault(state, -1);
    }

    private static List<Integer> list(int[] numbers) {
        return java.util.Arrays.stream(numbers).boxed().toList();
    }
}
