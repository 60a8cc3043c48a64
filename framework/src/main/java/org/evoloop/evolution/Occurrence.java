package org.evoloop.evolution;

import java.util.Locale;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.State;
import org.jspecify.annotations.Nullable;

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
 * @param found the state in which the device was found; null for an ordinary event
 */
public record Occurrence(
        Event event,
        Source source,
        boolean deviceActed,
        long visit,
        long observedNanos,
        @Nullable State found) {
    /** The visit of an occurrence that no state raised. */
    public static final long ANY_VISIT = 0;

    /** An ordinary event. */
    public Occurrence(Event event, Source source, boolean deviceActed, long visit, long observedNanos) {
        this(event, source, deviceActed, visit, observedNanos, null);
    }

    /**
     * The device was found in {@code state}, after it was out of sight or did what its model does not know.
     *
     * @param state a state of the original model
     */
    public static Occurrence found(State state, long observedNanos) {
        return new Occurrence(new Event("found " + state), Source.DEVICE, true, ANY_VISIT, observedNanos, state);
    }

    /** For messages: {@code Clean (panel, the device acted)}. */
    @Override
    public String toString() {
        return event + " (" + source.name().toLowerCase(Locale.ROOT) + (deviceActed ? ", the device acted)" : ")");
    }
}
