package org.evoloop.statechart;

import static java.util.Objects.requireNonNull;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.BitSet;
import java.util.Comparator;
import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.function.Function;
import org.jspecify.annotations.Nullable;

/** Finds every stable state of a machine, and what each event does there. */
final class Explorer {
    static final int MAX_STATES = 100_000;
    static final int MAX_MOVES = 1_000_000;
    /** For one event in one state: twelve independent guards. */
    private static final int MAX_CASES = 4_096;

    /**
     * The effort spent on a machine that may be too large, counted in active states examined; about a second. Such a
     * machine may still turn out small, if its regions change together.
     */
    private static final long TRIED = 1_000_000;
    /** The effort of a step that is not plain. */
    private static final int FULL_STEP = 20;

    private static final int NONE = -1;

    private static final String SMALLER = "draw fewer regions side by side, or histories, or guards on one event";

    private final Net net;
    private final Set<Problem> problems = new LinkedHashSet<>();
    private final List<Reached> reached = new ArrayList<>();
    /**
     * The numbers of the states in which only one vertex matters, by that vertex; {@link #NONE} for a vertex without.
     * Most states are like this and need no hashing.
     */
    private final int[] alone;

    private final Map<StableConfiguration, Reached> others = new HashMap<>();
    private final Map<String, Cause> events = new HashMap<>();
    /** Null if the machine cannot be too large. */
    private final @Nullable SizeEstimate tooLarge;

    private long tried;
    /** Whether the states explored now cannot be reached. */
    private boolean unreachable;

    private final BitSet visited = new BitSet();
    private int explored;
    private int moveCount;
    private @Nullable Case start;

    Explorer(Net net) {
        this.net = net;
        this.alone = new int[net.nodes().size()];
        Arrays.fill(alone, NONE);
        SizeEstimate estimate = new SizeEstimate(net);
        this.tooLarge = estimate.exceeds(MAX_STATES, MAX_MOVES) ? estimate : null;
    }

    /**
     * What happens for certain values of the guards.
     *
     * @param outcome null if nothing happens
     * @param deferred whether the event is deferred in that case
     */
    private record Case(List<String> guards, @Nullable StepResult outcome, boolean deferred) {}

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

    /** The outcome of starting the machine; null if there are problems. */
    @Nullable
    StepResult start() {
        return start == null ? null : start.outcome();
    }

    /** Every stable state, by number. */
    List<Reached> reached() {
        return reached;
    }

    /** Every stable state, in document order. */
    List<Reached> inOrder() {
        List<Reached> ordered = new ArrayList<>(reached.size());
        for (int number : alone) {
            if (number != NONE) {
                ordered.add(reached.get(number));
            }
        }
        if (!others.isEmpty()) {
            ordered.addAll(others.values());
            ordered.sort(Comparator.comparing(state -> state.snapshot));
        }
        return ordered;
    }

    /** The state with this snapshot. */
    Reached reached(StableConfiguration state) {
        return requireNonNull(find(state));
    }

    private void begin() {
        List<Case> cases = cases(RunToCompletion::start);
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
        while (explored < reached.size()) {
            Reached state = reached.get(explored++);
            List<Move> moves = moves(state);
            moveCount += moves.size();
            if (moveCount > MAX_MOVES) {
                throw new Refused(
                        net.chart().place(), "the flat machine has more than " + MAX_MOVES + " transitions", SMALLER);
            }
            state.moves = moves;
        }
    }

    /** States that are never entered still belong to the model; the checks report them. */
    private void visitUnreachable() {
        unreachable = true;
        for (Node node : net.nodes()) {
            if (!visited.get(node.index) && node.isState() && node.zones.isEmpty()) {
                visit(node);
                exploreAll();
            }
        }
    }

    private void visit(Node unreached) {
        try {
            for (Case one : cases(step -> step.startIn(unreached))) {
                if (one.outcome() != null) {
                    found(one.outcome());
                }
            }
        } catch (Refused refused) {
            add(refused);
        }
    }

    private List<Move> moves(Reached state) {
        Node node = PlainSteps.alone(net, state.snapshot);
        List<Move> moves = new ArrayList<>();
        if (node == null || node.hasRivals() || !node.deferred().isEmpty()) {
            causes(state.snapshot).forEach((cause, owners) -> {
                Link link = owners.size() == 1 && cause.kind() != Cause.Kind.COMPLETION
                        ? PlainSteps.only(owners.get(0), cause.name(), state.snapshot)
                        : null;
                if (link == null) {
                    step(state, cause, moves);
                } else {
                    moves.add(plain(link, cause, state.snapshot));
                }
            });
            return moves;
        }
        // Each trigger occurs on only one transition, so no lookup is needed.
        Set<Node> left = Set.of(node);
        for (Link link : node.outgoing) {
            boolean plain = PlainSteps.isPlain(link);
            List<String> triggers = link.arc.triggers();
            for (int i = 0; i < triggers.size(); i++) {
                if (net.isRaised(triggers.get(i))) {
                    continue;
                }
                Cause cause = cause(triggers.get(i), node);
                if (plain) {
                    take(link);
                    moves.add(plain(link, cause, left));
                } else {
                    step(state, cause, moves);
                }
            }
        }
        if (awaitsActivity(node)) {
            step(state, new Cause(Cause.Kind.COMPLETION, "", node), moves);
        }
        return moves;
    }

    /** The move of a state that may have orthogonal states beside it. */
    private Move plain(Link link, Cause cause, StableConfiguration state) {
        work(state.leaves().length);
        visited.set(link.target.index);
        StableConfiguration after = state.with(link.source, link.target);
        return new Move(cause, List.of(), number(after), PlainSteps.effects(link), false, Set.of(link.source), false);
    }

    private void work(long amount) {
        tried += amount;
        if (tooLarge != null && tried > TRIED) {
            Node widest = tooLarge.widest();
            throw new Refused(
                    widest == null ? net.chart().place() : widest.vertex.place(),
                    "the flat machine would have " + tooLarge
                            + (widest == null
                                    ? ""
                                    : "; " + widest + " has " + widest.zones.size() + " regions side by side")
                            + "; at most " + MAX_STATES + " states and " + MAX_MOVES + " transitions are built",
                    SMALLER);
        }
    }

    /** Reaches the target of a plain transition. */
    private void take(Link link) {
        visited.set(link.target.index);
        if (alone[link.target.index] == NONE) {
            reach(StableConfiguration.of(link.target));
        }
    }

    private Move plain(Link link, Cause cause, Set<Node> left) {
        return new Move(cause, List.of(), alone[link.target.index], PlainSteps.effects(link), false, left, false);
    }

    /** Adds the moves for a cause. */
    private void step(Reached state, Cause cause, List<Move> moves) {
        work((long) FULL_STEP * state.snapshot.leaves().length);
        try {
            moves.addAll(steps(state, cause));
        } catch (Refused refused) {
            add(refused);
        }
    }

    private void add(Refused refused) {
        if (!unreachable || !refused.onlyWhenReached()) {
            problems.add(refused.problem());
        }
    }

    private List<Move> steps(Reached state, Cause cause) {
        List<Case> cases = cases(step -> step.react(state.snapshot, cause));
        List<Move> found = new ArrayList<>();
        for (int i = 0; i < cases.size(); i++) {
            Case one = cases.get(i);
            StepResult outcome = one.outcome();
            if (outcome != null) {
                found.add(new Move(
                        cause,
                        one.guards(),
                        found(outcome),
                        outcome.effects(),
                        outcome.still(),
                        outcome.left(),
                        false));
            } else if (one.deferred()) {
                found.add(new Move(cause, one.guards(), state.index, List.of(), true, Set.of(), true));
            } else if (hides(one, cases.subList(i + 1, cases.size()))) {
                found.add(nothing(cause, one.guards(), state));
            }
        }
        if (found.isEmpty() && cause.kind() == Cause.Kind.TIME) {
            // The timer runs even if nothing happens here, and a later state may need it.
            found.add(nothing(cause, List.of(), state));
        }
        return found;
    }

    private static Move nothing(Cause cause, List<String> guards, Reached state) {
        return new Move(cause, guards, state.index, List.of(), true, Set.of(), false);
    }

    /** Whether a later move would wrongly be taken in this case, in which nothing happens. */
    private static boolean hides(Case nothing, List<Case> later) {
        return later.stream()
                .anyMatch(one -> one.outcome() != null && nothing.guards().containsAll(one.guards()));
    }

    private int found(StepResult outcome) {
        outcome.entered().forEach(node -> visited.set(node.index));
        return number(outcome.target());
    }

    private int number(StableConfiguration state) {
        Reached known = find(state);
        return (known == null ? reach(state) : known).index;
    }

    private @Nullable Reached find(StableConfiguration state) {
        if (!state.isOneState()) {
            return others.get(state);
        }
        int number = alone[state.leaves()[0]];
        return number == NONE ? null : reached.get(number);
    }

    private Reached reach(StableConfiguration state) {
        if (reached.size() >= MAX_STATES) {
            throw new Refused(net.chart().place(), "the flat machine has more than " + MAX_STATES + " states", SMALLER);
        }
        Reached added = new Reached(reached.size(), state);
        reached.add(added);
        if (state.isOneState()) {
            alone[state.leaves()[0]] = added.index;
        } else {
            others.put(state, added);
        }
        return added;
    }

    private List<Case> cases(Function<RunToCompletion, @Nullable StepResult> run) {
        GuardCases guards = new GuardCases();
        List<Case> cases = new ArrayList<>();
        do {
            RunToCompletion step = RunToCompletion.of(net, guards);
            StepResult outcome = run.apply(step);
            cases.add(new Case(guards.held(), outcome, outcome == null && step.isDeferring()));
            if (cases.size() > MAX_CASES) {
                throw new Refused(
                        net.chart().place(),
                        "one event has more than " + MAX_CASES + " outcomes in one state",
                        SMALLER);
            }
        } while (guards.next());
        return cases;
    }

    /** Everything that can happen, with the active states that have transitions on it or defer it. */
    private Map<Cause, List<Node>> causes(StableConfiguration state) {
        Map<Cause, List<Node>> causes = new LinkedHashMap<>();
        Set<Node> seen = new HashSet<>();
        for (int leaf : state.leaves()) {
            if (net.node(leaf).is(Vertex.Kind.TERMINATE)) {
                return causes;
            }
            for (Node node = net.node(leaf); node != null && seen.add(node); node = node.zone.owner) {
                for (String trigger : node.triggers()) {
                    if (!net.isRaised(trigger)) {
                        add(cause(trigger, node), node, causes);
                    }
                }
                for (String event : node.deferred()) {
                    add(cause(event, node), node, causes);
                }
                if (awaitsActivity(node) && !isDone(state, node)) {
                    add(new Cause(Cause.Kind.COMPLETION, "", node), node, causes);
                }
            }
        }
        return causes;
    }

    private static void add(Cause cause, Node node, Map<Cause, List<Node>> causes) {
        causes.computeIfAbsent(cause, key -> new ArrayList<>(1)).add(node);
    }

    private Cause cause(String trigger, Node owner) {
        return net.isTime(trigger)
                ? new Cause(Cause.Kind.TIME, trigger, owner)
                : events.computeIfAbsent(trigger, name -> new Cause(Cause.Kind.EVENT, name, null));
    }

    /** Whether the state has completion transitions that wait for the end of its do activity, as in UML. */
    private boolean awaitsActivity(Node node) {
        return !net.isScxml() && node.wantsCompletion() && !node.activities().isEmpty();
    }

    private static boolean isDone(StableConfiguration state, Node node) {
        for (int done : state.done()) {
            if (done == node.index) {
                return true;
            }
        }
        return false;
    }
}
