package org.evoloop.statechart;

import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.stream.Collectors;
import org.evoloop.statemachine.ModelException;
import org.evoloop.statemachine.State;
import org.evoloop.statemachine.StateMachine;
import org.jspecify.annotations.Nullable;

/**
 * A statechart and the flat machine that is equivalent to it (Harel, "Statecharts", 1987; UML 2.5.1, clause 14.2.3): it
 * accepts the same events and runs the same behaviors in the same order. Its states are the combinations of innermost
 * states in which the machine rests, with what it remembers for histories. Where UML leaves a choice:
 *
 * <ul>
 *   <li>Guards are evaluated when the event comes, each once, including those after a choice. A path without an enabled
 *   branch is not taken. Of the transitions of a state on one event, the guarded ones come first, in drawing order,
 *   then the one without guard, then {@code [else]}.
 *   <li>An event goes to the innermost state that has a transition for it; enclosing states do not see it. Orthogonal
 *   regions all see it, in drawing order, and are left and entered in that order.
 *   <li>Each part of a transition through pseudostates leaves and enters what lies between its two ends. A history
 *   remembers its region when the state around that is left; a region that has reached its final state is forgotten.
 *   <li>A guard on the only transition of an initial pseudostate, or on the default one of a history, is not asked for,
 *       since nothing else could be entered.
 *   <li>A local transition between a state and one in it leaves the region of the inner one alone, and enters it by
 *   default if it ends at the outer one. From a state to itself it leaves and enters again what is in the state; of a
 *   state without regions it is internal.
 *   <li>A state without do activity is complete when it is entered, or when all its regions have reached their final
 *       states; its transition without event is taken at once. If its guard does not hold then, it never is. The end of
 *       a do activity on which a transition waits is an event, {@code completion(NAME)}, that somebody must raise.
 *   <li>An event that a state defers waits if no transition of that state, of one in it, or of a region beside it
 *   counts for it; states around the deferring one do not see it. See {@link
 *   org.evoloop.statemachine.StateMachine#defers}.
 *   <li>A time trigger belongs to the state it leaves and goes on as long as that is not left; see
 *       {@link org.evoloop.statemachine.Transition#keeps}.
 *   <li>A transition that is internal and has no effects stands for an event that is swallowed.
 * </ul>
 *
 * <p>States that no event leads to are kept, as if something led there. Two transitions of which nothing says which is
 * taken are a problem.
 *
 * <p>Threading: immutable.
 *
 * @since 0.1
 */
public final class Flattening {
    private final List<Problem> problems;
    private final @Nullable StateMachine machine;
    private final @Nullable FlatMachine flat;
    private final List<Arc> unused;

    private Flattening(
            List<Problem> problems, @Nullable StateMachine machine, @Nullable FlatMachine flat, List<Arc> unused) {
        this.problems = List.copyOf(problems);
        this.machine = machine;
        this.flat = flat;
        this.unused = unused;
    }

    /** Flattens a chart, or finds out why that is impossible. */
    public static Flattening of(Statechart chart) {
        List<Problem> problems = new ArrayList<>();
        Net net = NetBuilder.build(chart, problems);
        if (problems.isEmpty()) {
            Rules.check(net, problems);
        }
        if (!problems.isEmpty()) {
            return failed(problems);
        }
        Explorer explorer = new Explorer(net);
        explorer.explore();
        problems.addAll(explorer.problems());
        Outcome start = explorer.start();
        if (!problems.isEmpty() || start == null) {
            return failed(problems);
        }
        try {
            FlatMachine flat = new FlatMachine(net, explorer.reached(), explorer.inOrder());
            StateMachine machine = flat.machine(explorer.reached(start.target()), start.effects());
            return new Flattening(problems, machine, flat, unused(net, explorer));
        } catch (ModelException refused) {
            return failed(
                    List.of(new Problem(chart.place(), String.valueOf(refused.getMessage()), "rename one of them")));
        }
    }

    private static Flattening failed(List<Problem> problems) {
        return new Flattening(problems, null, null, List.of());
    }

    private static List<Arc> unused(Net net, Explorer explorer) {
        Set<Arc> arcs = new LinkedHashSet<>();
        for (Node node : net.nodes()) {
            for (Link link : node.outgoing) {
                if (!explorer.uses(link)) {
                    arcs.add(link.arc);
                }
            }
        }
        return List.copyOf(arcs);
    }

    /**
     * The flat machine of a chart.
     *
     * @throws ModelException if there is none; the message lists all problems
     */
    public static StateMachine flatten(Statechart chart) {
        Flattening flattening = of(chart);
        if (!flattening.problems.isEmpty()) {
            throw new ModelException("state machine '" + chart.name() + "': "
                    + flattening.problems.stream().map(Problem::toString).collect(Collectors.joining("; ")));
        }
        return flattening.machine();
    }

    /** Why there is no flat machine; empty if there is one. */
    public List<Problem> problems() {
        return problems;
    }

    /**
     * The flat machine.
     *
     * @throws IllegalStateException if there are problems
     */
    public StateMachine machine() {
        if (machine == null) {
            throw new IllegalStateException("there is no flat machine: " + problems);
        }
        return machine;
    }

    /** The flat machine's states, each with the innermost states as drawn that are active in it, region by region. */
    public Map<State, List<Vertex>> leaves() {
        return flat == null ? Map.of() : flat.leaves();
    }

    /** Drawn transitions that can never be taken. */
    public List<Arc> unused() {
        return unused;
    }
}
