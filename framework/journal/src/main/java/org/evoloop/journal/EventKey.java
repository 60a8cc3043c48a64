package org.evoloop.journal;

import java.util.HashMap;
import java.util.Map;
import org.evoloop.evolution.Occurrence;
import org.evoloop.evolution.Source;

/**
 * An observed event, whichever models it is told to.
 *
 * @param number of those that were observed in the same nanosecond, from 0; where a test's clock stands still there are several
 */
record EventKey(String label, Source source, long observedNanos, int number) {

    /** Numbers events in their order. */
    static final class Sequence {
        private final Map<EventKey, Integer> taken = new HashMap<>();

        /** The key of an event that is the next of its kind. */
        EventKey next(Occurrence occurrence) {
            EventKey first = first(occurrence);
            return new EventKey(first.label, first.source, first.observedNanos, taken.getOrDefault(first, 0));
        }

        /** The same, and the one after it has another key. */
        EventKey take(Occurrence occurrence) {
            EventKey next = next(occurrence);
            taken.merge(first(occurrence), 1, Integer::sum);
            return next;
        }

        private static EventKey first(Occurrence occurrence) {
            return new EventKey(occurrence.label(), occurrence.source(), occurrence.observedNanos(), 0);
        }
    }
}
