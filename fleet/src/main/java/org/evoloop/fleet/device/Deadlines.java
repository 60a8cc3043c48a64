package org.evoloop.fleet.device;

import java.util.HashSet;
import java.util.Map;
import java.util.Set;
import org.evoloop.engine.Pending;
import org.evoloop.engine.Rules;
import org.evoloop.engine.Snapshot;
import org.evoloop.evolution.Occurrence;
import org.evoloop.evolution.Source;
import org.evoloop.statemachine.Event;
import org.jspecify.annotations.Nullable;

/** Finds the next timer that is due at a device. */
final class Deadlines {
    /** The value if nothing is due. */
    static final long NONE = Long.MAX_VALUE;

    private Deadlines() {}

    /**
     * The first timer of the visit to expire; null if none runs, or all have expired and their events are queued, or the
     * queue has no room for one.
     */
    static Map.@Nullable Entry<Event, Long> next(Snapshot snapshot, Rules rules) {
        Map<Event, Long> deadlines = snapshot.visit().deadlines();
        if (deadlines.isEmpty()
                || !snapshot.open()
                || snapshot.visit().over()
                || !rules.hasRoomForTimer(snapshot.waiting())) {
            return null;
        }
        Set<Event> waiting = waiting(snapshot);
        Map.Entry<Event, Long> next = null;
        for (Map.Entry<Event, Long> timer : deadlines.entrySet()) {
            if (!waiting.contains(timer.getKey()) && (next == null || timer.getValue() < next.getValue())) {
                next = timer;
            }
        }
        return next;
    }

    private static Set<Event> waiting(Snapshot snapshot) {
        if (snapshot.waiting().isEmpty()) {
            return Set.of();
        }
        Set<Event> waiting = new HashSet<>();
        for (Pending pending : snapshot.waiting()) {
            if (pending.occurrence() instanceof Occurrence.Heard heard
                    && heard.source() == Source.TIMER
                    && heard.visit() == snapshot.visit().number()) {
                waiting.add(heard.event());
            }
        }
        return waiting;
    }
}
