package org.evoloop.benchmarks.decision;

import java.util.HashMap;
import java.util.Map;

/** The simplest implementation with strings: a map of maps. */
final class HashMapWalker extends Walker {
    private final Map<String, Map<String, String>> targets = new HashMap<>();
    private String state;

    HashMapWalker(Walk walk) {
        state = walk.initial();
        for (Walk.Move move : walk.moves()) {
            targets.computeIfAbsent(move.source(), source -> new HashMap<>()).put(move.event(), move.target());
        }
    }

    @Override
    void fire(String event) {
        String target = targets.getOrDefault(state, Map.of()).get(event);
        if (target != null) {
            state = target;
            act();
        }
    }
}
