package org.evoloop.check.temporal;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.evoloop.check.PairGraph;
import org.evoloop.core.Outcome;
import org.evoloop.evolution.Configuration;
import org.evoloop.evolution.Decision;
import org.evoloop.evolution.DecisionTable;
import org.evoloop.evolution.Occurrence;
import org.evoloop.evolution.Turn;
import org.evoloop.statemachine.Event;
import org.jspecify.annotations.Nullable;

/**
 * Watches what happens, and says which property is broken and when: at the first moment after which it can no longer be
 * kept, whatever follows. What must come sometime is open as long as it has not come; that is never broken, since it
 * may still come. What can happen, as in {@code can F}, the models say of the moment.
 *
 * <p>It keeps what is left to be done of each property, of which there are finitely many, and nothing of the past.
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

    /** How a property stands. */
    public enum Standing {
        /** It is not broken, and nothing that must come is missing. */
        KEPT,
        /** It is not broken, and something that must come has not come yet. */
        OPEN,
        /** It is broken. */
        BROKEN
    }

    /**
     * Begins where the models do, or elsewhere. What led there is then not known: it is taken to have been the shortest
     * way, on which nothing counts as broken.
     *
     * @param properties to be watched
     * @param table of a valid pair
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

    /** Those that this moment has broken. */
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

    /** What is watched, in order. */
    public List<Property> properties() {
        return properties;
    }

    /**
     * How a property stands after what has happened so far.
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

    /** Those that are broken, in order. */
    public List<Property> broken() {
        return properties.stream()
                .filter(property -> standing(property) == Standing.BROKEN)
                .toList();
    }

    /** From here on other decisions of the same models say what can happen. */
    public void decideBy(DecisionTable table) {
        outlook = new Outlook(table);
    }

    /**
     * An event has led somewhere, maybe where it was before.
     *
     * @param last the event; null if none led there, as where the device was found elsewhere
     * @return the properties that this has broken
     */
    public List<Property> happened(Configuration at, @Nullable Event last) {
        now = new Moment(at, last == null ? now.last() : last.trigger());
        return see();
    }

    /**
     * An occurrence has come to its end, as {@link org.evoloop.core.Outputs#ended} tells. An event that was ignored,
     * came too late, was lost or failed has not happened, unless it has moved something all the same.
     *
     * @param after where device and evolved system stand then
     * @return the properties that this has broken
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
            // Of what failed only its effects, the transition is taken.
            case FAILED -> decision != null && !(decision instanceof Decision.Impossible);
            case STALE, DROPPED -> false;
        };
    }
}
