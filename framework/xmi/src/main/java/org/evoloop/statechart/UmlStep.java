package org.evoloop.statechart;

import static java.util.Objects.requireNonNull;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.Deque;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import org.evoloop.statechart.Vertex.Kind;
import org.jspecify.annotations.Nullable;

/**
 * One run-to-completion step: what happens from one event until the machine is stable again, for given values of the
 * guards.
 *
 * <p>This is UML's step. Innermost transitions are tried first, and regions in the order in which they are drawn. All guards are evaluated
 * when the event occurs, including those after choices. A path through pseudostates is not taken if none of its
 * branches holds.
 */
final class UmlStep implements RunToCompletion {
    private final Net net;
    private final GuardCases guards;
    private Body body;

    private final Set<Node> asleep = new HashSet<>();
    private boolean deferring;

    UmlStep(Net net, GuardCases guards) {
        this.net = net;
        this.guards = guards;
        this.body = new Body(net, this::path);
    }

    /** Transitions taken as one: a path from a state through pseudostates to the next stable vertex. */
    private record Take(Node state, List<Link> path) {
        Link first() {
            return path.get(0);
        }

        boolean isGuarded() {
            return path.stream().anyMatch(link -> !link.arc.guard().isEmpty());
        }
    }

    @Override
    public StepResult start() {
        body.enterTop();
        complete();
        return body.outcome();
    }

    @Override
    public StepResult startIn(Node state) {
        body.enterFrom(state);
        complete();
        return body.outcome();
    }

    @Override
    public @Nullable StepResult react(StableConfiguration before, Cause cause) {
        body.active().load(before);
        if (cause.kind() == Cause.Kind.COMPLETION && cause.owner() != null) {
            body.finish(cause.owner());
        } else {
            List<Take> takes = select(cause);
            return takes.isEmpty() ? null : decided(before, takes);
        }
        complete();
        return body.outcome();
    }

    /**
     * Takes as many of these transitions as can be taken together. Where UML leaves open which, every choice must have
     * the same outcome.
     */
    private StepResult decided(StableConfiguration before, List<Take> takes) {
        Rivals rivals = new Rivals(takes.stream()
                .map(take -> new Rivals.Rival(
                        body.exitedBy(take.path()), take.first().isInternal() ? take.state() : null, take.isGuarded()))
                .toList());
        StepResult decided = null;
        for (List<Integer> choice : rivals.choices()) {
            StepResult outcome = take(before, choice.stream().map(takes::get).toList());
            if (decided != null && !decided.isLike(outcome)) {
                throw undecided(takes, rivals);
            }
            decided = decided == null ? outcome : decided;
        }
        return requireNonNull(decided);
    }

    private static Refused undecided(List<Take> takes, Rivals rivals) {
        int[] pair = rivals.undecided();
        Link one = takes.get(pair[0]).first();
        Link other = takes.get(pair[1]).first();
        return Refused.whenReached(
                other.arc.place(),
                "one event triggers two transitions in different regions of which only one can be taken: " + one
                        + " and " + other,
                "give one of them another event, or guard both");
    }

    private StepResult take(StableConfiguration before, List<Take> takes) {
        body = new Body(net, this::path);
        body.active().load(before);
        takes.forEach(take -> body.follow(take.path()));
        complete();
        return body.outcome();
    }

    @Override
    public boolean isDeferring() {
        return deferring;
    }

    private List<Take> select(Cause cause) {
        List<Node> active = body.active().all();
        active.sort(Comparator.<Node>comparingInt(node -> -node.zone.depth).thenComparingInt(node -> node.index));
        List<Take> takes = new ArrayList<>();
        for (Node state : active) {
            if (!asleep.contains(state) && (cause.owner() == null || cause.owner() == state)) {
                Take take = first(state, state.on(cause.name()));
                if (take != null) {
                    takes.add(take);
                    passOver(state);
                } else if (cause.owner() == null && state.deferred().contains(cause.name())) {
                    deferring = true;
                    passOver(state);
                }
            }
        }
        takes.sort(Comparator.comparingInt(take -> take.state().index));
        Set<Node> joins = new HashSet<>();
        takes.removeIf(take -> take.first().target.is(Kind.JOIN) && !joins.add(take.first().target));
        return takes;
    }

    /** Inner transitions take precedence over those of enclosing states. */
    private void passOver(Node state) {
        for (Node outer = state; outer != null; outer = outer.zone.owner) {
            asleep.add(outer);
        }
    }

    private @Nullable Take first(Node state, List<Link> links) {
        for (Link link : links) {
            if (holds(link)) {
                List<Link> path = path(link);
                if (path != null) {
                    return new Take(state, path);
                }
            }
        }
        return null;
    }

    private boolean holds(Link link) {
        return !link.isGuarded() || guards.holds(link.arc.guard());
    }

    /**
     * The path that begins with {@code first} and continues through pseudostates; null if no branch of one of them
     * holds.
     */
    private @Nullable List<Link> path(Link first) {
        List<Link> path = new ArrayList<>();
        Link last = first;
        Set<Node> passed = new HashSet<>();
        while (true) {
            path.add(last);
            Node node = last.target;
            if (node.isTarget() || node.isSplit() || node.outgoing.isEmpty()) {
                return path;
            }
            if (!passed.add(node)) {
                throw new Refused(
                        node.vertex.place(),
                        "transitions lead in a circle through the " + node,
                        "draw a state on the circle");
            }
            if (node.is(Kind.JOIN) && !isReady(node, last)) {
                return null;
            }
            Link next = null;
            for (Link branch : node.outgoing) {
                if (holds(branch)) {
                    next = branch;
                    break;
                }
            }
            if (next == null) {
                return null;
            }
            last = next;
        }
    }

    private boolean isReady(Node join, Link arriving) {
        boolean awaitsCompletion = arriving.arc.triggers().isEmpty();
        for (Link link : join.incoming) {
            if (!body.active().has(link.source)
                    || (awaitsCompletion && !body.active().isComplete(link.source))
                    || !holds(link)) {
                return false;
            }
        }
        return true;
    }

    /** Takes completion transitions until no state is complete. */
    private void complete() {
        Set<Object> passed = new HashSet<>();
        Deque<Node> waiting = body.completions();
        while (!waiting.isEmpty()) {
            List<Node> now = new ArrayList<>(waiting);
            Node state = waiting.remove();
            Take take = body.active().has(state) ? first(state, state.onCompletion()) : null;
            if (take == null) {
                continue;
            }
            if (!passed.add(List.of(body.active().snapshot(), now))) {
                throw Refused.endless(take.first());
            }
            body.follow(take.path());
        }
    }
}
