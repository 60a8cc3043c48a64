package org.evoloop.statechart;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collection;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.TreeSet;
import org.evoloop.statechart.Vertex.Kind;
import org.jspecify.annotations.Nullable;

/** The active vertex of each region, and the parts of the past that matter. */
final class ActiveStates {
    private final Net net;
    private final Map<Zone, Node> active = new HashMap<>();
    private final TreeMap<Integer, int[]> memory = new TreeMap<>();
    private final TreeSet<Integer> done = new TreeSet<>();
    private @Nullable Node terminated;

    ActiveStates(Net net) {
        this.net = net;
    }

    void load(StableConfiguration snapshot) {
        for (int leaf : snapshot.leaves()) {
            Node node = net.node(leaf);
            if (node.is(Kind.TERMINATE)) {
                terminated = node;
                return;
            }
            while (node != null && active.putIfAbsent(node.zone, node) == null) {
                node = node.zone.owner;
            }
        }
        int[] written = snapshot.memory();
        for (int i = 0; i < written.length; i += 2 + written[i + 1]) {
            memory.put(written[i], Arrays.copyOfRange(written, i + 2, i + 2 + written[i + 1]));
        }
        for (int state : snapshot.done()) {
            done.add(state);
        }
    }

    /** The machine's current state. */
    StableConfiguration snapshot() {
        if (terminated != null) {
            return new StableConfiguration(new int[] {terminated.index}, new int[0], new int[0]);
        }
        List<Integer> leaves = new ArrayList<>();
        net.tops().forEach(top -> leaves(top, leaves));
        requireComplete();
        List<Integer> written = new ArrayList<>();
        memory.forEach((zone, vertices) -> {
            written.add(zone);
            written.add(vertices.length);
            for (int vertex : vertices) {
                written.add(vertex);
            }
        });
        return new StableConfiguration(ints(leaves), ints(written), ints(done));
    }

    /** Whatever is drawn, a stable machine is in one state of each region of each active state. */
    private void requireComplete() {
        net.tops().forEach(this::requireActive);
        all().forEach(node -> node.zones.forEach(this::requireActive));
    }

    private void requireActive(Zone zone) {
        if (!active.containsKey(zone)) {
            throw new Refused(
                    zone.region.place(),
                    "the machine would be in no state of " + zone,
                    "draw the transitions into it to its states");
        }
    }

    private static int[] ints(Collection<Integer> numbers) {
        return numbers.stream().mapToInt(Integer::intValue).toArray();
    }

    private void leaves(Zone zone, List<Integer> leaves) {
        Node node = active.get(zone);
        if (node == null) {
            return;
        }
        if (node.zones.isEmpty()) {
            leaves.add(node.index);
        }
        for (Zone inner : node.zones) {
            leaves(inner, leaves);
        }
    }

    List<Node> all() {
        return new ArrayList<>(active.values());
    }

    /** The active vertex of a region; null if there is none. */
    @Nullable
    Node in(Zone zone) {
        return active.get(zone);
    }

    boolean has(Node node) {
        return active.get(node.zone) == node;
    }

    void add(Node node) {
        active.put(node.zone, node);
    }

    void remove(Node node) {
        active.remove(node.zone);
        done.remove(node.index);
    }

    /** Terminates the machine. */
    void terminate(Node node) {
        terminated = node;
        active.clear();
    }

    boolean isTerminated() {
        return terminated != null;
    }

    /** Records that the do activity of an active state has ended. */
    void finish(Node state) {
        done.add(state.index);
    }

    boolean isComplete(Node state) {
        return (state.activities().isEmpty() || done.contains(state.index))
                && state.zones.stream().allMatch(zone -> {
                    Node node = active.get(zone);
                    return node != null && node.isFinal();
                });
    }

    /**
     * Remembers the active vertices of a region that is about to be left, if it has a history. UML forgets a region that
     * has reached its final state, SCXML does not.
     */
    void remember(Zone zone) {
        Node node = active.get(zone);
        if (!zone.hasHistory || node == null) {
            return;
        }
        if (node.isFinal() && !net.isScxml()) {
            memory.remove(zone.index);
        } else if (zone.nodes.stream().anyMatch(history -> history.is(Kind.DEEP_HISTORY))) {
            List<Integer> leaves = new ArrayList<>();
            leaves(zone, leaves);
            memory.put(zone.index, ints(leaves));
        } else {
            memory.put(zone.index, new int[] {node.index});
        }
    }

    /** What was active when the region was left. Null if the region was never active or had reached its final state. */
    @Nullable
    List<Node> remembered(Zone zone) {
        int[] vertices = memory.get(zone.index);
        return vertices == null
                ? null
                : Arrays.stream(vertices).mapToObj(net::node).toList();
    }
}
