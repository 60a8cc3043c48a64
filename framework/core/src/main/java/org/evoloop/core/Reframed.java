package org.evoloop.core;

import java.util.List;
import org.evoloop.evolution.Occurrence;

/** Occurrences as another visit, or another clock, has them. */
final class Reframed {
    private Reframed() {}

    static Occurrence inVisit(Occurrence occurrence, long visit) {
        return of(occurrence, visit, occurrence.observedNanos());
    }

    static Occurrence later(Occurrence occurrence, long nanos) {
        return of(occurrence, occurrence.visit(), occurrence.observedNanos() + nanos);
    }

    static List<Occurrence> later(List<Occurrence> occurrences, long nanos) {
        return occurrences.stream().map(occurrence -> later(occurrence, nanos)).toList();
    }

    private static Occurrence of(Occurrence occurrence, long visit, long atNanos) {
        if (occurrence instanceof Occurrence.Heard heard) {
            return new Occurrence.Heard(
                    heard.event(),
                    heard.values(),
                    heard.source(),
                    heard.deviceActed(),
                    heard.holding(),
                    visit,
                    atNanos);
        } else if (occurrence instanceof Occurrence.Asked asked) {
            return new Occurrence.Asked(asked.event(), asked.values(), visit, atNanos);
        } else if (occurrence instanceof Occurrence.Found found) {
            return new Occurrence.Found(found.state(), atNanos);
        }
        return new Occurrence.InDoubt(((Occurrence.InDoubt) occurrence).why(), atNanos);
    }
}
