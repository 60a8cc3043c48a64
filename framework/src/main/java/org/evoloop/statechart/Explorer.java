package org.evoloop.statechart;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.BitSet;
import java.util.Collection;
import java.util.Deque;
import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.function.Function;
import org.jspecify.annotations.Nullable;

/** Finds every state in which a machine can rest, and what each event does there. */
final class Explorer {
    private static final int MAX_STATES = 100_000;
    private static final int MAX_MOVES = 1_000_000;
    /** Of one event in one state: twelve guards that depend on nothing. */
    private static final int MAX_CASES = 4_096;

    private static final String SMALLER = "draw fewer regions side by side, or histories, or guards on one event";

    private final Net net;
    private final PlainSteps plainSteps;
    private final Set<Problem> problems = new LinkedHashSet<>();
    private final Map<Snapshot, List<Move>> moves = new HashMap<>();
    private final Deque<Snapshot> unexplored = new ArrayDeque<>();
    private final BitSet visited = new BitSet();
    private final BitSet used = new BitSet();
    private int moveCount;
    private @Nullable Case start;

    Explorer(Net net) {
        this.net = net;
        this.plainSteps = new PlainSteps(net);
    }

    /** What happens for some values of the guards; {@code outcome} is null if nothing does. */
    private record Case(List<String> guards, @Nullable Outcome outcome) {}

    /** What an event does when its guards hold and those of earlier moves do not. */
    record Move(Cause cause, List<String> guards, Outcome outcome) {}

    void explore() {
        try {
            begin();
            exploreAll();
            visitUnreachable();
        } catch (Refused refused) {
            problems.add(refused.problem());
        }
    }

    Set<Problem> problems() {
        return problems;
    }

    /** Where the machine starts; null if there are problems. */
    @Nullable
    Outcome start() {
        return start == null ? null : start.outcome();
    }

    /** What each event does in each state in which the machine can rest. */
    Map<Snapshot, List<Move>> moves() {
        return moves;
    }

    /** Whether a transition is ever taken. */
    boolean uses(Link link) {
        return used.get(link.index);
    }

    private void begin() {
        List<Case> cases = cases(Step::start);
        for (Case one : cases) {
            if (one.outcome() != null) {
                if (start != null) {
                    throw new Refused(
                            net.chart().place(),
                            "the state in which the machine starts depends on the guard ["
                                    + start.guards().get(start.guards().size() - 1) + "]",
                            "draw a first state, and an event on the guarded transition");
                }
                start = one;
                found(one.outcome());
            }
        }
    }

    private void exploreAll() {
        while (!unexplored.isEmpty()) {
            Snapshot state = unexplored.remove();
            List<Move> found = new ArrayList<>();
            for (Cause cause : causes(state)) {
                try {
                    found.addAll(moves(state, cause));
                } catch (Refused refused) {
                    problems.add(refused.problem());
                }
            }
            moveCount += found.size();
            if (moveCount > MAX_MOVES) {
                throw new Refused(
                        net.chart().place(), "the flat machine has more than " + MAX_MOVES + " transitions", SMALLER);
            }
            moves.put(state, found);
        }
    }

    /** States that are never entered are a part of the model all the same; a check tells their author. */
    private void visitUnreachable() {
        for (Node node : net.nodes()) {
            if (node.isState() && node.zones.isEmpty() && !visited.get(node.index)) {
                for (Case one : cases(step -> step.startIn(node))) {
                    if (one.outcome() != null) {
                        found(one.outcome());
                    }
                }
                exploreAll();
            }
        }
    }

    private List<Move> moves(Snapshot state, Cause cause) {
        Outcome plain = plainSteps.react(state, cause);
        if (plain != null) {
            found(plain);
            return List.of(new Move(cause, List.of(), plain));
        }
        List<Case> cases = cases(step -> step.react(state, cause));
        List<Move> found = new ArrayList<>();
        for (int i = 0; i < cases.size(); i++) {
            Case one = cases.get(i);
            if (one.outcome() != null) {
                found(one.outcome());
                found.add(new Move(cause, one.guards(), one.outcome()));
            } else if (hides(one, cases.subList(i + 1, cases.size()))) {
                found.add(new Move(cause, one.guards(), nothing(state)));
            }
        }
        if (found.isEmpty() && cause.kind() == Cause.Kind.TIME) {
            // Its timer runs all the same, and may be wanted in a state that comes later.
            found.add(new Move(cause, List.of(), nothing(state)));
        }
        return found;
    }

    private static Outcome nothing(Snapshot state) {
        return new Outcome(state, List.of(), Set.of(), Set.of(), Set.of());
    }

    /** Whether a later move would wrongly be taken for this case, in which nothing happens. */
    private static boolean hides(Case nothing, List<Case> later) {
        return later.stream()
                .anyMatch(one -> one.outcome() != null && nothing.guards().containsAll(one.guards()));
    }

    private void found(Outcome outcome) {
        outcome.used().forEach(link -> used.set(link.index));
        outcome.entered().forEach(node -> visited.set(node.index));
        Snapshot state = outcome.target();
        if (moves.containsKey(state)) {
            return;
        }
        if (moves.size() >= MAX_STATES) {
            throw new Refused(net.chart().place(), "the flat machine has more than " + MAX_STATES + " states", SMALLER);
        }
        moves.put(state, List.of());
        unexplored.add(state);
    }

    private List<Case> cases(Function<Step, @Nullable Outcome> run) {
        Guards guards = new Guards();
        List<Case> cases = new ArrayList<>();
        do {
            Outcome outcome = run.apply(new Step(net, guards));
            cases.add(new Case(guards.held(), outcome));
            if (cases.size() > MAX_CASES) {
                throw new Refused(
                        net.chart().place(),
                        "one event has more than " + MAX_CASES + " outcomes in one state",
                        SMALLER);
            }
        } while (guards.next());
        return cases;
    }

    private Collection<Cause> causes(Snapshot state) {
        // A state by itself names no event twice.
        Collection<Cause> causes = PlainSteps.isAlone(net, state) ? new ArrayList<>() : new LinkedHashSet<>();
        Set<Node> seen = new HashSet<>();
        for (int leaf : state.leaves()) {
            if (net.node(leaf).is(Vertex.Kind.TERMINATE)) {
                return causes;
            }
            for (Node node = net.node(leaf); node != null && seen.add(node); node = node.zone.owner) {
                for (String trigger : node.triggers()) {
                    causes.add(
                            net.isTime(trigger)
                                    ? new Cause(Cause.Kind.TIME, trigger, node)
                                    : new Cause(Cause.Kind.EVENT, trigger, null));
                }
                if (node.wantsCompletion() && !node.activities().isEmpty() && !isDone(state, node)) {
                    causes.add(new Cause(Cause.Kind.COMPLETION, "", node));
                }
            }
        }
        return causes;
    }

    private static boolean isDone(Snapshot state, Node node) {
        for (int done : state.done()) {
            if (done == node.index) {
                return true;
            }
        }
        return false;
    }
}
