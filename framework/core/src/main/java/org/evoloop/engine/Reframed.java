package org.evoloop.engine;

import java.util.List;
import org.evoloop.evolution.Occurrence;
import org.evoloop.statemachine.Event;

/**
 * Copies of occurrences for another visit, clock or event.
 *
 * @since 0.1
 */
public final class Reframed {
    private Reframed() {}

    /** A copy that belongs to {@code visit}. */
    public static Occurrence inVisit(Occurrence occurrence, long visit) {
        return of(occurrence, visit, occurrence.observedNanos());
    }

    /** A copy with another event, for a timer that has been renamed. */
    static Occurrence as(Event event, Occurrence.Heard heard) {
        return heard(event, heard, heard.visit(), heard.observedNanos());
    }

    static Occurrence later(Occurrence occurrence, long nanos) {
        return of(occurrence, occurrence.visit(), occurrence.observedNanos() + nanos);
    }

    static List<Occurrence> later(List<Occurrence> occurrences, long nanos) {
        return occurrences.stream().map(occurrence -> later(occurrence, nanos)).toList();
    }

    private static Occurrence of(Occurrence occurrence, long visit, long atNanos) {
        if (occurrence instanceof Occurrence.Heard heard) {
            return heard(heard.event(), heard, visit, atNanos);
        } else if (occurrence instanceof Occurrence.Asked asked) {
            return new Occurrence.Asked(asked.event(), asked.values(), visit, atNanos);
        } else if (occurrence instanceof Occurrence.Found found) {
            return new Occurrence.Found(found.state(), atNanos);
        } else if (occurrence instanceof Occurrence.Evolved evolved) {
            return new Occurrence.Evolved(evolved.model(), atNanos);
        } else if (occurrence instanceof Occurrence.Violated violated) {
            return new Occurrence.Violated(violated.property(), atNanos);
        }
        return new Occurrence.InDoubt(((Occurrence.InDoubt) occurrence).why(), atNanos);
    }

    private static Occurrence heard(Event event, Occurrence.Heard heard, long visit, long atNanos) {
        return new Occurrence.Heard(
                event, heard.values(), heard.source(), heard.deviceActed(), heard.holding(), visit, atNanos);
    }
}
