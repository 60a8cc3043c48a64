package org.evoloop.statechart;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.BitSet;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.function.Function;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;

/**
 * Names the flat states. A state has the name of its innermost state, or its path {@code Outer.Inner} if that name is
 * not unique; orthogonal states are {@code (A, B)}. States that would still have equal names get a suffix in brackets:
 * what histories remember, and the do activities that have ended.
 */
final class FlatNames {
    private final Net net;
    private final List<StableConfiguration> states;
    /** Whether {@link ChartRules} have made sure that all names are different: those of the states of a single region. */
    private final boolean inOneRegion;

    private final Set<String> ambiguousLeaves;
    /** The names made of the innermost vertices alone. */
    private final List<String> leaves = new ArrayList<>();
    /** Computed on first use, since it is rarely needed. */
    private @Nullable Set<String> ambiguousStates;

    /** @param states all flat states, in order */
    FlatNames(Net net, List<StableConfiguration> states) {
        this.net = net;
        this.states = states;
        this.inOneRegion = net.isOneRegion()
                && states.stream()
                        .allMatch(state -> state.isOneState()
                                && net.node(state.leaves()[0]).isState());
        this.ambiguousLeaves = inOneRegion ? Set.of() : ambiguous(visited());
        states.forEach(state -> leaves.add(leaves(state)));
    }

    private Stream<Node> visited() {
        BitSet visited = new BitSet();
        for (StableConfiguration state : states) {
            for (int leaf : state.leaves()) {
                visited.set(leaf);
            }
        }
        return visited.stream().mapToObj(net::node);
    }

    private static Set<String> ambiguous(Stream<Node> nodes) {
        Set<String> names = new HashSet<>();
        return nodes.map(Node::simpleName).filter(name -> !names.add(name)).collect(Collectors.toSet());
    }

    /** The name of a drawn state. */
    String of(Node node) {
        if (ambiguousStates == null) {
            ambiguousStates = ambiguous(net.nodes().stream().filter(Node::isState));
        }
        return ambiguousStates.contains(node.simpleName()) ? node.path() : node.simpleName();
    }

    /** The names of all flat states, in order; all are different. */
    List<String> all() {
        if (inOneRegion || areDifferent(leaves)) {
            return leaves;
        }
        List<String> names = new ArrayList<>(leaves);
        makeDistinct(names, this::done);
        makeDistinct(names, this::remembered);
        int[] number = {1};
        while (!areDifferent(names)) {
            makeDistinct(names, state -> " " + number[0]++);
        }
        return names;
    }

    /**
     * The names of all flat states without their memory, in order. Where such a name would be ambiguous, it is the one
     * in {@code names}.
     *
     * @param names as returned by {@link #all}
     */
    List<String> withoutMemory(List<String> names) {
        if (names.equals(leaves)) {
            return names;
        }
        Map<String, int[]> leavesOf = new HashMap<>();
        Set<String> ambiguous = new HashSet<>();
        for (int i = 0; i < names.size(); i++) {
            int[] vertices = states.get(i).leaves();
            int[] others = leavesOf.putIfAbsent(leaves.get(i), vertices);
            if (others != null && !Arrays.equals(others, vertices)) {
                ambiguous.add(leaves.get(i));
            }
        }
        List<String> plain = new ArrayList<>(leaves);
        for (int i = 0; i < names.size(); i++) {
            if (ambiguous.contains(plain.get(i))) {
                plain.set(i, names.get(i));
            }
        }
        return plain;
    }

    private static boolean areDifferent(List<String> names) {
        return new HashSet<>(names).size() == names.size();
    }

    private void makeDistinct(List<String> names, Function<StableConfiguration, String> suffix) {
        Map<String, Integer> count = new HashMap<>();
        names.forEach(name -> count.merge(name, 1, Integer::sum));
        for (int i = 0; i < names.size(); i++) {
            if (count.getOrDefault(names.get(i), 0) > 1) {
                names.set(i, names.get(i) + suffix.apply(states.get(i)));
            }
        }
    }

    private String leaves(StableConfiguration state) {
        int[] vertices = state.leaves();
        return vertices.length == 1 ? leaf(net.node(vertices[0])) : "(" + String.join(", ", names(vertices)) + ")";
    }

    private String done(StableConfiguration state) {
        return state.done().length == 0 ? "" : " [done " + String.join(", ", names(state.done())) + "]";
    }

    private String remembered(StableConfiguration state) {
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
