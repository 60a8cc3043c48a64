package org.evoloop.statechart;

import java.util.List;

/**
 * A transition as drawn.
 *
 * <p>Threading: immutable.
 *
 * @param source key of the vertex that it leaves
 * @param target key of the vertex that it enters
 * @param triggers names of the events that trigger it, any of them; none for a completion transition and for segments
 *     between pseudostates
 * @param guard text of the condition; empty for none, {@code else} for the branch that remains
 * @param effects behaviors on taking it, in order
 * @param spontaneous those of the triggers that are drawn as the device's own, see {@link Spontaneous}
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
        List<String> spontaneous) {
    public Arc {
        triggers = List.copyOf(triggers);
        effects = List.copyOf(effects);
        spontaneous = List.copyOf(spontaneous);
    }

    /** @param drawn the triggers, with the keyword {@link Spontaneous} before those that are the device's own */
    public Arc(
            Place place,
            String source,
            String target,
            List<String> drawn,
            String guard,
            List<String> effects,
            Kind kind) {
        this(place, source, target, Spontaneous.unmarked(drawn), guard, effects, kind, Spontaneous.marked(drawn));
    }

    /** What a transition does with its source. */
    public enum Kind {
        /** Leaves it. */
        EXTERNAL,
        /**
         * Does not leave the one of its ends that is around the other. Between a state and itself it leaves and enters
         * what is in the state; else it is the same as an external one.
         */
        LOCAL,
        /** Leaves nothing. */
        INTERNAL
    }
}
