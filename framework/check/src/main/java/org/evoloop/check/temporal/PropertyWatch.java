package org.evoloop.check.temporal;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.evoloop.check.PairGraph;
import org.evoloop.evolution.Configuration;
import org.evoloop.evolution.Decision;
import org.evoloop.evolution.DecisionTable;
import org.evoloop.evolution.Occurrence;
import org.evoloop.evolution.Outcome;
import org.evoloop.evolution.Turn;
import org.evoloop.statemachine.Event;
import org.jspecify.annotations.Nullable;

/**
 * Watches what happens, and reports a property as violated at the first moment after which it can no longer be
 * satisfied, whatever follows. A property that requires something to come is open until it comes; it is never violated,
 * since that may still come. What can happen, as in {@code can F}, is determined by the models.
 *
 * <p>For each property it stores only what is still required, which has finitely many values, and nothing of the past.
 *
 * <p>Threading: not thread-safe.
 *
 * @since 0.1
 */
public final class PropertyWatch {
    private final Map<Property, Watched> watched = new LinkedHashMap<>();
    private final List<Property> properties;
    private Outlook outlook;
    private Moment now;

    /** The status of a property. */
    public enum Standing {
        /** It is not violated, and nothing that must come is missing. */
        KEPT,
        /** It is not violated, but something that must come has not come yet. */
        OPEN,
        /** It is violated. */
        BROKEN
    }

    /**
     * Begins in the models' initial states, or in others. The events that led there are then unknown: they are assumed
     * to be the shortest way, on which nothing counts as violated.
     *
     * @param properties the properties to watch
     * @param table the decisions for a valid pair
     */
    public PropertyWatch(List<Property> properties, DecisionTable table, Configuration from) {
        this.properties = List.copyOf(properties);
        this.outlook = new Outlook(table);
        Configuration initial = table.models().initial();
        this.now = new Moment(initial, null);
        properties.forEach(property -> watched.put(property, new Watched(property)));
        if (!from.equals(initial)) {
            for (Turn turn : new PairGraph(initial, table).wayTo(from)) {
                see();
                now = new Moment(turn.decision().after(), turn.event().trigger());
            }
            now = new Moment(from, now.last());
            watched.values().stream().filter(Watched::isBroken).forEach(Watched::forget);
        }
        see();
    }

    /** The properties that this moment has violated. */
    private List<Property> see() {
        List<Property> broken = List.of();
        for (Watched each : watched.values()) {
            if (!each.isBroken() && each.breaksIn(now, outlook)) {
                broken = new ArrayList<>(broken);
                broken.add(each.property());
            }
        }
        return broken;
    }

    /** The watched properties, in order. */
    public List<Property> properties() {
        return properties;
    }

    /**
     * The status of a property so far.
     *
     * @param property one of {@link #properties}
     */
    public Standing standing(Property property) {
        Watched of = watched.get(property);
        if (of == null) {
            throw new IllegalArgumentException("'" + property.name() + "' is not watched");
        }
        return of.isBroken() ? Standing.BROKEN : of.isOpen() ? Standing.OPEN : Standing.KEPT;
    }

    /** The violated properties, in order. */
    public List<Property> broken() {
        return properties.stream()
                .filter(property -> standing(property) == Standing.BROKEN)
                .toList();
    }

    /** Sets the decisions of the same models that determine from now on what can happen. */
    public void decideBy(DecisionTable table) {
        outlook = new Outlook(table);
    }

    /**
     * An event has led to these states, possibly unchanged.
     *
     * @param last the event; null if none led there, for example if the device was found in another state
     * @return the properties that this has violated
     */
    public List<Property> happened(Configuration at, @Nullable Event last) {
        now = new Moment(at, last == null ? now.last() : last.trigger());
        return see();
    }

    /**
     * An occurrence has ended, as reported by {@link org.evoloop.engine.Outputs#ended}. An event that was ignored, came
     * too late, was lost or failed has not happened, unless it has changed a state all the same.
     *
     * @param after the states of device and evolved system then
     * @return the properties that this has violated
     */
    public List<Property> ended(
            Occurrence occurrence, Configuration after, Outcome outcome, @Nullable Decision decision) {
        Event event = eventOf(occurrence);
        boolean moved = !after.equals(now.at());
        return moved || (event != null && isTaken(outcome, decision)) ? happened(after, event) : List.of();
    }

    private static @Nullable Event eventOf(Occurrence occurrence) {
        if (occurrence instanceof Occurrence.Heard heard) {
            return heard.event();
        }
        return occurrence instanceof Occurrence.Asked asked ? asked.event() : null;
    }

    private static boolean isTaken(Outcome outcome, @Nullable Decision decision) {
        return switch (outcome) {
            case HANDLED -> true;
            case IGNORED -> decision != null && !decision.steps().isEmpty();
            // If only effects failed, the transition was taken.
            case FAILED, OVERTAKEN -> decision != null && !(decision instanceof Decision.Impossible);
            case STALE, DROPPED -> false;
        };
    }
}
