package org.evoloop.check.temporal;

import static java.util.Objects.requireNonNull;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.BiPredicate;
import java.util.function.Predicate;
import org.evoloop.check.temporal.MomentGraph.Edge;
import org.evoloop.evolution.ModelPair;

/**
 * Which formulas surely hold or surely fail, whatever functions send. A function decides by itself whether and what it
 * sends, at once or later, but it does not send for ever. So what should always be so, must be so after each of its
 * sends; and what can happen, must be possible wherever it has left the device.
 *
 * <p>A formula about which nothing is sure may still hold, or fail, for every function: then it is not seen here.
 *
 * <p>Threading: not thread-safe; it caches its results.
 *
 * @since 0.1
 */
public final class Assurance {
    private final MomentGraph graph;
    private final ModelPair pair;
    private final Map<Moment, Place> places = new HashMap<>();
    private final Map<Formula, Set<Moment>> holding = new HashMap<>();
    private final Map<Formula, Set<Moment>> failing = new HashMap<>();

    /** The moments from which a function leads to one by sending. */
    private final Map<Moment, List<Moment>> sentFrom = new HashMap<>();

    /**
     * What can follow a moment.
     *
     * @param turns the moments to which events lead
     * @param sends those to which the function leads
     */
    private record Place(Set<Moment> turns, Set<Moment> sends) {}

    /** @param graph with what functions may send */
    public Assurance(MomentGraph graph, ModelPair pair) {
        this.graph = graph;
        this.pair = pair;
        for (Moment moment : graph.moments()) {
            Place place = new Place(next(moment, edge -> !edge.isSent()), next(moment, Edge::isSent));
            places.put(moment, place);
            place.sends()
                    .forEach(sent -> sentFrom.computeIfAbsent(sent, target -> new ArrayList<>())
                            .add(moment));
        }
    }

    private Set<Moment> next(Moment moment, Predicate<Edge> wanted) {
        Set<Moment> found = new HashSet<>();
        graph.from(moment).stream().filter(wanted).forEach(edge -> found.add(edge.target()));
        return found;
    }

    /**
     * Whether {@code formula} holds from the start, whatever functions send; empty if that is not sure, since it may
     * depend on it.
     */
    public Optional<Boolean> verdict(Formula formula) {
        for (boolean holds : new boolean[] {true, false}) {
            if (sure(formula, holds).contains(graph.initial())) {
                return Optional.of(holds);
            }
        }
        return Optional.empty();
    }

    /** The moments in which {@code formula} surely holds, or surely fails. */
    private Set<Moment> sure(Formula formula, boolean holds) {
        Map<Formula, Set<Moment>> known = holds ? holding : failing;
        Set<Moment> found = known.get(formula);
        if (found == null) {
            found = find(formula, holds);
            known.put(formula, found);
        }
        return found;
    }

    private Set<Moment> find(Formula formula, boolean holds) {
        if (formula.isPlain()) {
            return only(moment -> formula.isSeenIn(moment, pair) == holds);
        } else if (formula instanceof Formula.Not not) {
            return sure(not.operand(), !holds);
        } else if (formula instanceof Formula.And and) {
            return holds ? both(and.left(), and.right(), true) : either(and.left(), and.right(), false);
        } else if (formula instanceof Formula.Or or) {
            return holds ? either(or.left(), or.right(), true) : both(or.left(), or.right(), false);
        } else if (formula instanceof Formula.Next next) {
            Set<Moment> wanted = sure(next.operand(), holds);
            return only(moment -> holds ? allNext(moment, wanted) : someNext(moment, wanted));
        } else if (formula instanceof Formula.Always always) {
            Set<Moment> wanted = sure(always.operand(), holds);
            return holds ? lasting(wanted, Set.of(), this::allNext) : possible(wanted, graph.moments());
        } else if (formula instanceof Formula.Can can) {
            Set<Moment> wanted = sure(can.operand(), holds);
            return holds ? possible(wanted, graph.moments()) : lasting(wanted, Set.of(), this::allNext);
        } else if (formula instanceof Formula.Eventually eventually) {
            Set<Moment> wanted = sure(eventually.operand(), holds);
            return holds ? inevitable(wanted, graph.moments()) : lasting(wanted, Set.of(), this::mayStay);
        } else if (formula instanceof Formula.Until until) {
            return holds
                    ? inevitable(sure(until.right(), true), sure(until.left(), true))
                    : lasting(sure(until.right(), false), both(until.left(), until.right(), false), this::mayStay);
        } else if (formula instanceof Formula.Unless unless) {
            return holds
                    ? lasting(sure(unless.left(), true), sure(unless.right(), true), this::allNext)
                    : possible(both(unless.left(), unless.right(), false), sure(unless.right(), false));
        }
        throw new AssertionError(formula);
    }

    private Set<Moment> both(Formula left, Formula right, boolean hold) {
        Set<Moment> both = new HashSet<>(sure(left, hold));
        both.retainAll(sure(right, hold));
        return both;
    }

    private Set<Moment> either(Formula left, Formula right, boolean hold) {
        Set<Moment> either = new HashSet<>(sure(left, hold));
        either.addAll(sure(right, hold));
        return either;
    }

    private boolean allNext(Moment moment, Set<Moment> wanted) {
        return wanted.containsAll(place(moment).turns())
                && wanted.containsAll(place(moment).sends());
    }

    private boolean someNext(Moment moment, Set<Moment> wanted) {
        return place(moment).turns().stream().anyMatch(wanted::contains)
                && wanted.containsAll(place(moment).sends());
    }

    private boolean mayStay(Moment moment, Set<Moment> wanted) {
        return place(moment).turns().isEmpty()
                ? wanted.containsAll(place(moment).sends())
                : someNext(moment, wanted);
    }

    private Place place(Moment moment) {
        return requireNonNull(places.get(moment));
    }

    /** The largest set of moments that are in {@code end}, or in {@code among} with {@code followed} by this set. */
    private Set<Moment> lasting(Set<Moment> among, Set<Moment> end, BiPredicate<Moment, Set<Moment>> followed) {
        Set<Moment> lasting = new HashSet<>(among);
        lasting.addAll(end);
        Set<Moment> before = Set.of();
        while (!before.equals(lasting)) {
            Set<Moment> known = new HashSet<>(lasting);
            lasting.removeIf(moment -> !end.contains(moment) && !followed.test(moment, known));
            before = known;
        }
        return lasting;
    }

    /** The moments from which some events lead to {@code goal} through {@code passable} ones. */
    private Set<Moment> possible(Set<Moment> goal, Set<Moment> passable) {
        return growing(
                goal,
                passable,
                (moment, known) -> place(moment).turns().stream().anyMatch(known::contains));
    }

    /** The moments from which all events lead to {@code goal} through {@code passable} ones. */
    private Set<Moment> inevitable(Set<Moment> goal, Set<Moment> passable) {
        return growing(
                goal,
                passable,
                (moment, known) -> !place(moment).turns().isEmpty()
                        && known.containsAll(place(moment).turns()));
    }

    private Set<Moment> growing(Set<Moment> goal, Set<Moment> passable, BiPredicate<Moment, Set<Moment>> leads) {
        Set<Moment> known = new HashSet<>(goal);
        boolean grows = true;
        while (grows) {
            Set<Moment> before = known;
            // The function may leave the device in any moment to which it leads, and wait there for an event.
            Set<Moment> more = exceptWhereSendsLeadTo(only(
                    moment -> !goal.contains(moment) && !(passable.contains(moment) && leads.test(moment, before))));
            known = new HashSet<>(more);
            known.addAll(before);
            grows = known.size() > before.size();
        }
        return known;
    }

    private Set<Moment> exceptWhereSendsLeadTo(Set<Moment> moments) {
        Set<Moment> found = new HashSet<>(moments);
        Deque<Moment> frontier = new ArrayDeque<>(moments);
        for (Moment at = frontier.poll(); at != null; at = frontier.poll()) {
            for (Moment sender : sentFrom.getOrDefault(at, List.of())) {
                if (found.add(sender)) {
                    frontier.add(sender);
                }
            }
        }
        return only(moment -> !found.contains(moment));
    }

    private Set<Moment> only(Predicate<Moment> test) {
        Set<Moment> found = new HashSet<>(graph.moments());
        found.removeIf(test.negate());
        return found;
    }
}
