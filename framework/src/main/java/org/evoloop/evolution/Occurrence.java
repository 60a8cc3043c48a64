package org.evoloop.evolution;

import org.evoloop.statemachine.Event;

/**
 * One occurrence of an event.
 *
 * <p>Threading: immutable.
 *
 * @param event what occurred
 * @param source where it came from
 * @param deviceActed whether the device has already acted on it by itself, so that its state has moved before anything
 *     was decided
 * @param visit the visit of a state it belongs to, or {@link #ANY_VISIT}; an occurrence that was raised during one
 *     visit means nothing to the next
 * @param observedNanos when it was observed, in nanoseconds of the converter's monotonic clock
 */
public record Occurrence(Event event, Source source, boolean deviceActed, long visit, long observedNanos) {
    /** The visit of an occurrence that no state raised. */
    public static final long ANY_VISIT = 0;

    /** For messages: {@code Clean (panel, the device acted)}. */
    @Override
    public String toString() {
        return event + " (" + source.name().toLowerCase(java.util.Locale.ROOT)
                + (deviceActed ? ", the device acted)" : ")");
    }
}
