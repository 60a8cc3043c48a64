package org.evoloop.statechart;

import java.util.List;

/**
 * A transition as drawn.
 *
 * <p>Threading: immutable.
 *
 * @param source key of the vertex that it leaves
 * @param target key of the vertex that it enters
 * @param triggers names of the events, any of which triggers it; empty for a completion transition and for segments
 *     between pseudostates
 * @param guard text of the condition; empty for none, {@code else} for the remaining branch
 * @param effects behaviors that run when it is taken, in order
 * @param spontaneous the triggers marked as raised by the device itself, see {@link EventKeywords}
 * @param urgent the triggers marked as urgent
 * @param order of the transitions of a state, in which SCXML tries them; 0 in UML
 * @since 0.1
 */
public record Arc(
        Place place,
        String source,
        String target,
        List<String> triggers,
        String guard,
        List<String> effects,
        Kind kind,
        List<String> spontaneous,
        List<String> urgent,
        int order) {
    public Arc {
        triggers = List.copyOf(triggers);
        effects = List.copyOf(effects);
        spontaneous = List.copyOf(spontaneous);
        urgent = List.copyOf(urgent);
    }

    /** @param drawn the triggers, with their {@link EventKeywords} */
    public Arc(
            Place place,
            String source,
            String target,
            List<String> drawn,
            String guard,
            List<String> effects,
            Kind kind) {
        this(place, source, target, drawn, guard, effects, kind, 0);
    }

    /** @param drawn the triggers, with their {@link EventKeywords} */
    public Arc(
            Place place,
            String source,
            String target,
            List<String> drawn,
            String guard,
            List<String> effects,
            Kind kind,
            int order) {
        this(
                place,
                source,
                target,
                EventKeywords.unmarked(drawn),
                guard,
                effects,
                kind,
                EventKeywords.marked(drawn, EventKeywords.SPONTANEOUS),
                EventKeywords.marked(drawn, EventKeywords.URGENT),
                order);
    }

    /** The keywords before one of its triggers, with a space behind them; empty if it has none. */
    public String keywords(String trigger) {
        return EventKeywords.before(spontaneous.contains(trigger), urgent.contains(trigger));
    }

    /** What a transition does with its source state. */
    public enum Kind {
        /** Leaves it. */
        EXTERNAL,
        /**
         * If one of its ends contains the other, does not leave the outer one. From a state to itself, it leaves and
         * enters what is inside the state. In all other cases it is the same as an external one.
         */
        LOCAL,
        /** Leaves nothing. */
        INTERNAL
    }
}
