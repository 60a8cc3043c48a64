package org.evoloop.journal;

import org.evoloop.evolution.Occurrence;
import org.evoloop.evolution.Source;

/** An observed event, whichever models it is told to. */
record EventKey(String label, Source source, long observedNanos) {
    static EventKey of(Occurrence occurrence) {
        return new EventKey(occurrence.label(), occurrence.source(), occurrence.observedNanos());
    }
}
