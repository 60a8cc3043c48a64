package org.evoloop.statechart;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.function.Supplier;
import java.util.stream.Collectors;
import org.evoloop.statemachine.ModelException;
import org.evoloop.statemachine.State;
import org.evoloop.statemachine.StateMachine;
import org.jspecify.annotations.Nullable;

/**
 * A statechart and its equivalent flat machine (Harel, "Statecharts", 1987; UML 2.5.1, clause 14.2.3). The flat machine
 * accepts the same events and runs the same behaviors in the same order. Its states are the stable state configurations
 * of the drawn machine, with what is remembered for histories. A chart of {@linkplain Statechart.Semantics#SCXML SCXML}
 * follows the algorithm of SCXML 1.0 (appendix D), except that each guard is evaluated once, when the event occurs. A
 * chart of UML follows UML; where UML leaves a choice:
 *
 * <ul>
 *   <li>Guards are evaluated when the event occurs, each of them once, including those after a choice. A path without
 *       an enabled branch is not taken. Of a state's transitions on one event, the guarded ones are tried first, in
 *       drawing order, then the one without a guard, then {@code [else]}.
 *   <li>An event goes to the innermost state that has a transition for it; enclosing states do not see it. All
 *       orthogonal regions see it, in drawing order, and are left and entered in that order.
 *   <li>Of transitions in different regions of which only one can be taken (both leave the same state, or one leaves the
 *       state in which the other is internal), the first is taken if one of them has a
 *       guard. Otherwise it is a problem, unless the outcome is the same whichever is taken, or the machine never comes
 *       there.
 *   <li>Each segment of a transition through pseudostates leaves and enters the states between its two ends. A fork has
 *       no place of its own: it is one segment with the transitions after it. A history
 *       remembers its region when the enclosing state is left; the memory of a region in its final state is cleared.
 *   <li>A guard on the only transition of an initial pseudostate, or on the default transition of a history, is not
 *       evaluated, since nothing else could be entered.
 *   <li>A local transition between a state and a state inside it leaves only the region of the inner state, and enters
 *       it by default if it ends at the outer state. From a state to itself it leaves and enters again what is inside
 *       the state; for a state without regions it is internal.
 *   <li>A state without a do activity is complete when it is entered, or when all its regions have reached their final
 *       states. Its completion transition is taken at once; if its guard does not hold then, it is never taken. If a
 *       transition waits for the end of a do activity, that end is an event, {@code completion(NAME)}, which the
 *       application must raise.
 *   <li>An event that a state defers waits, unless that state, a state inside it, or an orthogonal region takes a
 *       transition on it. Enclosing states do not see it. See {@link org.evoloop.statemachine.StateMachine#defers}.
 *   <li>The timer of a time trigger belongs to the transition's source state, and runs until that state is left; see
 *       {@link org.evoloop.statemachine.Transition#keeps}.
 *   <li>An internal transition without effects means that the event is consumed without a reaction.
 * </ul>
 *
 * <p>Unreachable states are kept, as if a transition led to them. If nothing determines which of two transitions is
 * taken, that is a problem.
 *
 * <p>Threading: immutable.
 *
 * @since 0.1
 */
public final class Flattening {
    private final List<Problem> problems;
    private final @Nullable StateMachine machine;
    private final Supplier<Map<State, List<Vertex>>> leaves;

    private Flattening(
            List<Problem> problems, @Nullable StateMachine machine, Supplier<Map<State, List<Vertex>>> leaves) {
        this.problems = List.copyOf(problems);
        this.machine = machine;
        this.leaves = leaves;
    }

    /** Of a chart without problems, all of whose transitions can be taken. */
    Flattening(StateMachine machine, Supplier<Map<State, List<Vertex>>> leaves) {
        this(List.of(), machine, leaves);
    }

    /** Flattens a chart, or finds the problems that prevent it. */
    public static Flattening of(Statechart chart) {
        Flattening flat = FlatChart.flatten(chart);
        return flat == null ? explored(chart) : flat;
    }

    /** Flattens any chart by exploring what can happen in it. */
    static Flattening explored(Statechart chart) {
        List<Problem> problems = new ArrayList<>();
        Net net = NetBuilder.build(chart, problems);
        if (problems.isEmpty()) {
            ChartRules.check(net, problems);
        }
        if (!problems.isEmpty()) {
            return failed(problems);
        }
        Explorer explorer = new Explorer(net);
        explorer.explore();
        problems.addAll(explorer.problems());
        StepResult start = explorer.start();
        if (!problems.isEmpty() || start == null) {
            return failed(problems);
        }
        try {
            FlatMachine flat = new FlatMachine(net, explorer.reached(), explorer.inOrder());
            StateMachine machine = flat.machine(explorer.reached(start.target()), start.effects());
            if (!flat.problems().isEmpty()) {
                return failed(List.copyOf(flat.problems()));
            }
            return new Flattening(problems, machine, flat::leaves);
        } catch (ModelException refused) {
            return failed(
                    List.of(new Problem(chart.place(), String.valueOf(refused.getMessage()), "rename one of them")));
        }
    }

    private static Flattening failed(List<Problem> problems) {
        return new Flattening(problems, null, Map::of);
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

    /** The problems that prevent a flat machine; empty if there is one. */
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

    /** The flat machine's states, each with the drawn innermost states that are active in it, region by region. */
    public Map<State, List<Vertex>> leaves() {
        return leaves.get();
    }
}
