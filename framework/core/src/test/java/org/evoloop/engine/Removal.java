package org.evoloop.engine;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Predicate;
import org.evoloop.evolution.Occurrence;
import org.evoloop.evolution.Source;

/** How a mechanism of the core is removed: what the core is given, and what becomes of its answer. */
interface Removal {
    String name();

    /** The word with which the violation begins. */
    String invariant();

    /** The scene in which the invariant is violated. */
    Scene scene();

    /** The core without the mechanism. */
    default Wiring wiring() {
        return (rules, before, input) -> {
            if (isLost(before, input)) {
                Occurrence lost = ((Input.Observed) input).occurrence();
                return new Wiring.Result(List.of(new Output.Dropped(lost, true)), Snapshots.lost(before));
            }
            List<Pending> hidden = hidden(before, input);
            Snapshot ahead = Snapshots.without(ahead(before, input), hidden);
            Wiring.Result real = Wiring.REAL.apply(rules(rules), ahead, input);
            Snapshot after = Snapshots.with(real.after(), hidden);
            return new Wiring.Result(unsay(before, input, real.said()), undo(before, input, after));
        };
    }

    /** Whether an occurrence is lost that the core would take. */
    default boolean isLost(Snapshot before, Input input) {
        return false;
    }

    /** What waits unnoticed while the core takes an input. */
    default List<Pending> hidden(Snapshot before, Input input) {
        return List.of();
    }

    /** The rules by which the core works. */
    default Rules rules(Rules rules) {
        return rules;
    }

    /** The snapshot that the core is given before an input. */
    default Snapshot ahead(Snapshot before, Input input) {
        return before;
    }

    default Snapshot undo(Snapshot before, Input input, Snapshot after) {
        return after;
    }

    default List<Output> unsay(Snapshot before, Input input, List<Output> said) {
        return said;
    }

    /** Whether a press finds as many occurrences as there are places, whatever these are. */
    default boolean isLostInAFullQueue(Snapshot before, Input input) {
        return input instanceof Input.Observed observed
                && observed.occurrence().source() == Source.CONTROLLER
                && before.open()
                && before.waiting().size() >= scene().rules().queueCapacity();
    }

    default boolean isFact(Input input) {
        return input instanceof Input.Observed observed
                && !(observed.occurrence() instanceof Occurrence.Asked)
                && (observed.occurrence().isFact()
                        || observed.occurrence().label().equals("endSpot"));
    }

    default List<Output> without(List<Output> said, Predicate<Output> unwanted) {
        List<Output> left = new ArrayList<>(said);
        left.removeIf(unwanted);
        return left;
    }
}
