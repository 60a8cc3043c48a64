package org.evoloop.models.temporal;

import org.evoloop.evolution.Configuration;
import org.evoloop.evolution.ModelPair;
import org.evoloop.statemachine.Event;
import org.jspecify.annotations.Nullable;

/**
 * What can be told of a running converter between two events.
 *
 * <p>Threading: immutable.
 *
 * @param at where both models stand
 * @param last the event that has led here, without its guards; null at the start
 */
record Moment(Configuration at, @Nullable Event last) {

    /** Whether {@code atom} is so. */
    boolean shows(Formula.Atom atom, ModelPair pair) {
        return switch (atom.kind()) {
            case STATE -> at.evolved().name().equals(atom.name());
            case DEVICE -> at.original().name().equals(atom.name());
            case EVENT -> last != null && last.name().equals(atom.name());
            case FUNCTION -> at.evolved().name().equals(atom.name()) && pair.isNew(at.evolved());
        };
    }
}
