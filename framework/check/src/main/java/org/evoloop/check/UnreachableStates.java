package org.evoloop.check;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.HashSet;
import java.util.Iterator;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Queue;
import java.util.Set;
import org.evoloop.statemachine.State;
import org.evoloop.statemachine.StateMachine;
import org.evoloop.statemachine.Transition;

/** The unreachable states to which nothing leads, without those to which only other unreachable states lead. */
final class UnreachableStates {
    private final StateMachine machine;
    private final Set<State> reachable;

    UnreachableStates(StateMachine machine, Set<State> reachable) {
        this.machine = machine;
        this.reachable = reachable;
    }

    /**
     * The smallest set of states from which all unreachable ones can be reached, each with the others to which it
     * leads. Of states that lead to each other, one is chosen.
     */
    Map<State, Set<State>> roots() {
        Map<State, Set<State>> roots = new LinkedHashMap<>();
        Set<State> seen = new HashSet<>(reachable);
        List<State> finished = finished();
        // A state that leads to another one, but not back, has finished after it.
        for (int i = finished.size() - 1; i >= 0; i--) {
            if (seen.add(finished.get(i))) {
                roots.put(finished.get(i), below(finished.get(i), seen));
            }
        }
        return roots;
    }

    /** The unreachable states to which these transitions lead, at once or through others. */
    Set<State> behind(List<Transition> transitions) {
        Set<State> seen = new HashSet<>(reachable);
        Set<State> behind = new LinkedHashSet<>();
        for (Transition transition : transitions) {
            if (seen.add(transition.target())) {
                behind.add(transition.target());
                behind.addAll(below(transition.target(), seen));
            }
        }
        return behind;
    }

    private Set<State> below(State root, Set<State> seen) {
        Set<State> below = new LinkedHashSet<>();
        Queue<State> frontier = new ArrayDeque<>(List.of(root));
        for (State at = frontier.poll(); at != null; at = frontier.poll()) {
            for (Transition transition : machine.transitionsFrom(at)) {
                if (seen.add(transition.target())) {
                    below.add(transition.target());
                    frontier.add(transition.target());
                }
            }
        }
        return below;
    }

    /** All unreachable states, each after those that it leads to first. */
    private List<State> finished() {
        Set<State> begun = new HashSet<>(reachable);
        List<State> finished = new ArrayList<>();
        for (State state : machine.states()) {
            if (begun.add(state)) {
                finish(state, begun, finished);
            }
        }
        return finished;
    }

    private record Visit(State state, Iterator<Transition> left) {}

    private void finish(State first, Set<State> begun, List<State> finished) {
        Deque<Visit> open = new ArrayDeque<>(List.of(visit(first)));
        while (!open.isEmpty()) {
            Visit visit = open.element();
            if (!visit.left().hasNext()) {
                finished.add(open.remove().state());
            } else {
                State next = visit.left().next().target();
                if (begun.add(next)) {
                    open.push(visit(next));
                }
            }
        }
    }

    private Visit visit(State state) {
        return new Visit(state, machine.transitionsFrom(state).iterator());
    }
}
