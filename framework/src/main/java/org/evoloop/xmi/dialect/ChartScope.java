package org.evoloop.xmi.dialect;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.evoloop.statechart.Arc;

/**
 * One machine as it stands in a chart, with the keys of its vertices. The machine of a submachine state is a scope of
 * its own within that of the state, so that the states of a machine that is used twice have two keys.
 *
 * <p>Threading: for one thread.
 *
 * @param <M> how a dialect calls a machine, with equality
 */
public final class ChartScope<M> {
    private static final int MAX_VERTICES = 500_000;
    private static final int MAX_NESTED_MACHINES = 50;

    private final M machine;
    private final String prefix;
    private final List<M> enclosing;
    /** Of the whole chart, since machines that use machines that use machines grow beyond any measure. */
    private final int[] vertices;

    private final Map<String, String> keys = new HashMap<>();
    private final Map<String, String> outerStates = new HashMap<>();
    private final Map<String, ChartScope<M>> submachines = new HashMap<>();
    private final Map<String, List<Arc>> internal = new HashMap<>();

    private ChartScope(M machine, String prefix, List<M> enclosing, int[] vertices) {
        this.machine = machine;
        this.prefix = prefix;
        this.enclosing = enclosing;
        this.vertices = vertices;
    }

    /** The scope of the machine that is read. */
    public static <M> ChartScope<M> of(M machine) {
        return new ChartScope<>(machine, "", List.of(), new int[1]);
    }

    /** The machine whose scope this is. */
    public M machine() {
        return machine;
    }

    /** The key of the vertex of this machine with this id. */
    public String key(String id) {
        return prefix + id;
    }

    /**
     * Makes a vertex known.
     *
     * @param outerStateKey of the state in which it stands; empty if it stands directly in the machine
     * @return what is wrong with it and how to mend it; empty if nothing is
     */
    public String define(String id, String outerStateKey) {
        String key = key(id);
        if (!outerStateKey.isEmpty()) {
            outerStates.put(key, outerStateKey);
        }
        if (id.isEmpty()) {
            return " has no id; export the model again with ids";
        }
        if (keys.putIfAbsent(id, key) != null) {
            return " has the id of another vertex; give each an id of its own";
        }
        return "";
    }

    /** Lets an id stand for a vertex that has another one. */
    public void alias(String id, String key) {
        keys.put(id, key);
    }

    /** The key of the vertex with this id; none if this machine has no such vertex. */
    public Optional<String> find(String id) {
        return Optional.ofNullable(keys.get(id));
    }

    /** The scope of the machine that a submachine state holds; none if the chart would have no end. */
    public Optional<ChartScope<M>> open(String stateId, M submachine) {
        List<M> outer = new ArrayList<>(enclosing);
        outer.add(machine);
        if (outer.contains(submachine) || outer.size() > MAX_NESTED_MACHINES) {
            return Optional.empty();
        }
        ChartScope<M> scope = new ChartScope<>(submachine, key(stateId) + "/", List.copyOf(outer), vertices);
        submachines.put(stateId, scope);
        return Optional.of(scope);
    }

    /** The machine that a submachine state holds; none for any other state. */
    public Optional<ChartScope<M>> submachine(String stateId) {
        return Optional.ofNullable(submachines.get(stateId));
    }

    /** The machines of all submachine states. */
    public List<ChartScope<M>> submachines() {
        return List.copyOf(submachines.values());
    }

    /** Counts one more vertex of the chart; false if there are too many. */
    public boolean fits() {
        return ++vertices[0] <= MAX_VERTICES;
    }

    /** Whether the vertex stands in the state, at any depth, or is it. */
    public boolean isWithin(String key, String stateKey) {
        String outer = key;
        while (outer != null && !outer.equals(stateKey)) {
            outer = outerStates.get(outer);
        }
        return outer != null;
    }

    /** Takes an internal transition. */
    public void addInternal(Arc arc) {
        internal.computeIfAbsent(arc.source(), key -> new ArrayList<>()).add(arc);
    }

    /** The internal transitions of the state with this key. */
    public List<Arc> internal(String key) {
        return internal.getOrDefault(key, List.of());
    }
}
