package org.evoloop.check;

import java.util.List;
import org.evoloop.evolution.Turn;

/**
 * A violation of a rule.
 *
 * <p>Threading: immutable.
 *
 * @param element the part of a model that it is about
 * @param message what is wrong, one sentence without a full stop
 * @param remedy how to fix it
 * @param example the turns from the start until it shows; empty if it shows in the drawing itself, or at once
 * @param timed the example with times, if they matter; else empty
 * @since 0.1
 */
public record Finding(
        Rule rule, Element element, String message, String remedy, List<Turn> example, List<TimedEvent> timed) {
    public Finding {
        example = List.copyOf(example);
        timed = List.copyOf(timed);
    }

    /** A finding in which times do not matter. */
    public Finding(Rule rule, Element element, String message, String remedy, List<Turn> example) {
        this(rule, element, message, remedy, example, List.of());
    }

    /** A finding that shows in the drawing itself. */
    Finding(Rule rule, Element element, String message, String remedy) {
        this(rule, element, message, remedy, List.of());
    }

    /** For messages: {@code trap-state: state Wait of the new model cannot be left; draw ...}. */
    @Override
    public String toString() {
        return rule.id() + ": " + message + "; " + remedy;
    }
}
