package org.evoloop.check.temporal;

import java.util.ArrayList;
import java.util.BitSet;
import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;

/**
 * The remaining duties of a property while moments are observed. There may be several ways to satisfy it, each a set of
 * duties from the next moment on; without any way left it is violated. The successor of a set of ways for the facts of
 * a moment is computed once: this is a deterministic automaton with states made on demand, of which there are finitely
 * many.
 *
 * <p>Threading: not thread-safe.
 */
final class Watched {
    private final Property property;
    private final List<Formula> facts;
    private final BitSet seen = new BitSet();
    private final Map<Set<Set<Duty>>, Place> places = new HashMap<>();
    private final Place start;
    private Place at;

    /** A state of the automaton, and its successors by facts. */
    private record Place(Set<Set<Duty>> ways, Map<BitSet, Place> next) {}

    Watched(Property property) {
        this.property = property;
        Duty duty = Duty.of(property.formula(), true);
        Set<Formula> found = new LinkedHashSet<>();
        collect(duty, found);
        facts = new ArrayList<>(found);
        start = place(Set.of(Set.of(duty)));
        at = start;
    }

    private static void collect(Duty duty, Set<Formula> facts) {
        if (duty instanceof Duty.Fact fact) {
            facts.add(fact.formula());
        } else if (duty instanceof Duty.Both both) {
            collect(both.left(), facts);
            collect(both.right(), facts);
        } else if (duty instanceof Duty.Either either) {
            collect(either.left(), facts);
            collect(either.right(), facts);
        } else if (duty instanceof Duty.Always always) {
            collect(always.duty(), facts);
        } else if (duty instanceof Duty.Next next) {
            collect(next.duty(), facts);
        } else if (duty instanceof Duty.Until until) {
            collect(until.left(), facts);
            collect(until.right(), facts);
        }
    }

    Property property() {
        return property;
    }

    /** Resets to the state before the first moment. */
    void forget() {
        at = start;
    }

    boolean isBroken() {
        return at.ways().isEmpty();
    }

    /** Whether, in every way to satisfy it, something that must come has not come. */
    boolean isOpen() {
        return !isBroken() && at.ways().stream().allMatch(way -> way.stream().anyMatch(Duty::isOwed));
    }

    /** Observes another moment; returns whether that violates the property. */
    boolean breaksIn(Moment moment, Outlook outlook) {
        for (int number = 0; number < facts.size(); number++) {
            seen.set(number, outlook.holds(facts.get(number), moment));
        }
        Place next = at.next().get(seen);
        if (next == null) {
            next = place(after(at.ways()));
            at.next().put((BitSet) seen.clone(), next);
        }
        at = next;
        return isBroken();
    }

    private Place place(Set<Set<Duty>> ways) {
        return places.computeIfAbsent(ways, all -> new Place(all, new HashMap<>()));
    }

    private Set<Set<Duty>> after(Set<Set<Duty>> ways) {
        Set<Set<Duty>> after = new HashSet<>();
        for (Set<Duty> way : ways) {
            Set<Set<Duty>> kept = Set.of(Set.of());
            for (Duty duty : way) {
                kept = both(kept, unfold(duty));
            }
            after.addAll(kept);
        }
        return shortest(after);
    }

    /** The ways to satisfy {@code duty} from the observed moment on. */
    private Set<Set<Duty>> unfold(Duty duty) {
        if (duty instanceof Duty.Fact fact) {
            return seen.get(facts.indexOf(fact.formula())) ? Set.of(Set.of()) : Set.of();
        } else if (duty instanceof Duty.Both both) {
            return both(unfold(both.left()), unfold(both.right()));
        } else if (duty instanceof Duty.Either either) {
            return either(unfold(either.left()), unfold(either.right()));
        } else if (duty instanceof Duty.Always always) {
            return both(unfold(always.duty()), Set.of(Set.of(always)));
        } else if (duty instanceof Duty.Next next) {
            return Set.of(Set.of(next.duty()));
        } else if (duty instanceof Duty.Until until) {
            return either(unfold(until.right()), both(unfold(until.left()), Set.of(Set.of(until))));
        }
        throw new AssertionError(duty);
    }

    private static Set<Set<Duty>> either(Set<Set<Duty>> left, Set<Set<Duty>> right) {
        Set<Set<Duty>> all = new HashSet<>(left);
        all.addAll(right);
        return shortest(all);
    }

    private static Set<Set<Duty>> both(Set<Set<Duty>> left, Set<Set<Duty>> right) {
        Set<Set<Duty>> all = new HashSet<>();
        for (Set<Duty> one : left) {
            for (Set<Duty> other : right) {
                Set<Duty> together = new HashSet<>(one);
                together.addAll(other);
                all.add(together);
            }
        }
        return shortest(all);
    }

    /** Removes each way that includes another one. */
    private static Set<Set<Duty>> shortest(Set<Set<Duty>> ways) {
        Set<Set<Duty>> shortest = new HashSet<>(ways);
        shortest.removeIf(way -> ways.stream().anyMatch(other -> other.size() < way.size() && way.containsAll(other)));
        return shortest;
    }
}
