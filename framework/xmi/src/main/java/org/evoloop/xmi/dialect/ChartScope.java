package org.evoloop.xmi.dialect;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.evoloop.statechart.Arc;
import org.evoloop.statemachine.ModelException;

/**
 * One machine within a chart, with the keys of its vertices. The machine of a submachine state has its own scope inside
 * that of the state, so that each use of a machine has separate keys.
 *
 * <p>Threading: for one thread.
 *
 * @param <M> a dialect's elements, with equality
 */
public final class ChartScope<M extends UmlElement> {
    private static final int MAX_VERTICES = 500_000;
    private static final int MAX_NESTED_MACHINES = 50;

    private final M machine;
    private final String prefix;
    private final List<M> enclosing;
    /** Counted for the whole chart, since nested submachines can grow beyond any limit. */
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

    /** The scope of a top-level machine. */
    public static <M extends UmlElement> ChartScope<M> of(M machine) {
        return new ChartScope<>(machine, "", List.of(), new int[1]);
    }

    /** The machine of this scope. */
    public M machine() {
        return machine;
    }

    /** The key of the vertex of this machine with this id. */
    public String key(String id) {
        return prefix + id;
    }

    /**
     * Registers a vertex.
     *
     * @param outerStateKey the key of the enclosing state; empty if it is directly in the machine
     * @throws ModelException if the chart has too many
     */
    public void define(M vertex, String outerStateKey, Problems problems) {
        String id = vertex.id();
        String key = key(id);
        if (!outerStateKey.isEmpty()) {
            outerStates.put(key, outerStateKey);
        }
        if (id.isEmpty()) {
            wrong(vertex, " has no id; export the model again with ids", problems);
        } else if (keys.putIfAbsent(id, key) != null) {
            wrong(vertex, " has the id of another vertex; give each an id of its own", problems);
        }
        if (++vertices[0] > MAX_VERTICES) {
            throw new ModelException(machine.file() + ": with its submachines, state machine " + machine.label()
                    + " (line " + machine.line() + ") is too large: use fewer of them");
        }
    }

    private static void wrong(UmlElement vertex, String what, Problems problems) {
        problems.add(vertex.line(), vertex.type() + " " + vertex.label() + what);
    }

    /** Adds another id for a vertex. */
    public void alias(String id, String key) {
        keys.put(id, key);
    }

    /** The key of the vertex with this id; none if this machine has no such vertex. */
    public Optional<String> find(String id) {
        return Optional.ofNullable(keys.get(id));
    }

    /**
     * Opens a scope for a submachine state's machine. Returns nothing, and reports a problem, if the chart would be
     * infinite.
     */
    public Optional<ChartScope<M>> open(M state, M submachine, Problems problems) {
        List<M> outer = new ArrayList<>(enclosing);
        outer.add(machine);
        if (outer.contains(submachine) || outer.size() > MAX_NESTED_MACHINES) {
            problems.add(
                    state.line(),
                    "submachine state " + state.label() + " holds state machine " + submachine.label()
                            + ", which contains this state; break the cycle");
            return Optional.empty();
        }
        ChartScope<M> scope = new ChartScope<>(submachine, key(state.id()) + "/", List.copyOf(outer), vertices);
        submachines.put(state.id(), scope);
        return Optional.of(scope);
    }

    /** The machine of a submachine state; empty for any other state. */
    public Optional<ChartScope<M>> submachine(String stateId) {
        return Optional.ofNullable(submachines.get(stateId));
    }

    /** The machines of all submachine states. */
    public List<ChartScope<M>> submachines() {
        return List.copyOf(submachines.values());
    }

    /** Whether the vertex is the state, or inside it at any depth. */
    public boolean isWithin(String key, String stateKey) {
        String outer = key;
        while (outer != null && !outer.equals(stateKey)) {
            outer = outerStates.get(outer);
        }
        return outer != null;
    }

    /** Adds an internal transition. */
    public void addInternal(Arc arc) {
        internal.computeIfAbsent(arc.source(), key -> new ArrayList<>()).add(arc);
    }

    /** The internal transitions of the state with this key. */
    public List<Arc> internal(String key) {
        return internal.getOrDefault(key, List.of());
    }
}
