package org.evoloop.statechart;

import java.util.ArrayList;
import java.util.Collection;
import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.function.Function;
import java.util.stream.Collectors;

/**
 * Names of flat states: that of the innermost state if no other has it, else its path {@code Outer.Inner}; of regions
 * side by side {@code (A, B)}. What is remembered for histories, and do activities that have ended, follow in brackets
 * where states would else have the same name.
 */
final class FlatNames {
    private final Net net;
    private final Set<String> ambiguousLeaves;
    private final Set<String> ambiguousStates;
    private final Collection<Snapshot> states;

    /** @param states all flat states, in order */
    FlatNames(Net net, Collection<Snapshot> states) {
        this.net = net;
        this.states = states;
        Set<Node> leaves = new HashSet<>();
        for (Snapshot state : states) {
            for (int leaf : state.leaves()) {
                leaves.add(net.node(leaf));
            }
        }
        this.ambiguousLeaves = ambiguous(leaves);
        this.ambiguousStates =
                ambiguous(net.nodes().stream().filter(Node::isState).toList());
    }

    private static Set<String> ambiguous(Collection<Node> nodes) {
        Set<String> names = new HashSet<>();
        return nodes.stream()
                .map(Node::simpleName)
                .filter(name -> !names.add(name))
                .collect(Collectors.toSet());
    }

    /** Of a state as drawn. */
    String of(Node node) {
        return ambiguousStates.contains(node.simpleName()) ? node.path() : node.simpleName();
    }

    /** Of all flat states, in their order; no two are equal. */
    Map<Snapshot, String> all() {
        Map<Snapshot, String> names = new LinkedHashMap<>();
        states.forEach(state -> names.put(state, leaves(state)));
        if (areDifferent(names)) {
            return names;
        }
        tellApart(names, this::done);
        tellApart(names, this::remembered);
        int[] number = {1};
        while (!areDifferent(names)) {
            tellApart(names, state -> " " + number[0]++);
        }
        return names;
    }

    private static boolean areDifferent(Map<Snapshot, String> names) {
        return new HashSet<>(names.values()).size() == names.size();
    }

    private static void tellApart(Map<Snapshot, String> names, Function<Snapshot, String> suffix) {
        Map<String, Integer> count = new HashMap<>();
        names.values().forEach(name -> count.merge(name, 1, Integer::sum));
        names.replaceAll((state, name) -> count.getOrDefault(name, 0) > 1 ? name + suffix.apply(state) : name);
    }

    private String leaves(Snapshot state) {
        List<String> names = names(state.leaves());
        return names.size() == 1 ? names.get(0) : "(" + String.join(", ", names) + ")";
    }

    private String done(Snapshot state) {
        return state.done().length == 0 ? "" : " [done " + String.join(", ", names(state.done())) + "]";
    }

    private String remembered(Snapshot state) {
        List<String> names = new ArrayList<>();
        int[] memory = state.memory();
        for (int i = 0; i < memory.length; i += 2 + memory[i + 1]) {
            for (int vertex = i + 2; vertex < i + 2 + memory[i + 1]; vertex++) {
                names.add(leaf(net.node(memory[vertex])));
            }
        }
        return names.isEmpty() ? "" : " [history " + String.join(", ", names) + "]";
    }

    private String leaf(Node node) {
        return ambiguousLeaves.contains(node.simpleName()) ? node.path() : node.simpleName();
    }

    private List<String> names(int[] vertices) {
        List<String> names = new ArrayList<>();
        for (int vertex : vertices) {
            names.add(leaf(net.node(vertex)));
        }
        return names;
    }
}
