package org.evoloop.engine;

import java.time.Duration;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Set;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.State;
import org.evoloop.statemachine.Transition;
import org.jspecify.annotations.Nullable;

/**
 * The visit of the current state, and the deadlines of its timers.
 */
final class Stay {
    private long number;
    private boolean over;
    private @Nullable Transition by;
    private boolean startOwed;

    /** Without timers that have fired. */
    private final Map<Event, Long> deadlines = new LinkedHashMap<>();

    Stay(Snapshot.OpenVisit visit) {
        restore(visit);
    }

    void restore(Snapshot.OpenVisit visit) {
        number = visit.number();
        over = visit.over();
        by = visit.by();
        startOwed = visit.startOwed();
        deadlines.clear();
        deadlines.putAll(visit.deadlines());
    }

    long number() {
        return number;
    }

    /** Whether it has ended, so that another must begin. */
    boolean isOver() {
        return over;
    }

    @Nullable
    Transition by() {
        return by;
    }

    boolean isCurrent(long visit) {
        return visit == number && number > 0;
    }

    void leave(Outputs out) {
        startOwed = false;
        if (!over) {
            over = true;
            out.leave();
        }
    }

    Snapshot.OpenVisit visit() {
        return new Snapshot.OpenVisit(number, over, by, inOrder(), startOwed);
    }

    /** Whether the function of this visit has yet to be started. */
    boolean isStartOwed() {
        return startOwed;
    }

    void oweStart(boolean owed) {
        startOwed = owed;
    }

    /**
     * Sets the timers for the next visit.
     *
     * @param kept names of time triggers that continue from the previous visit, since a state enclosing both is not
     *     left
     */
    void prepare(State state, @Nullable Transition leading, Set<String> kept, Rules rules, long atNanos) {
        by = leading;
        Map<Event, Duration> timers = rules.timers().of(state);
        if (!timers.isEmpty() || !deadlines.isEmpty()) {
            deadlines.keySet().removeIf(event -> !kept.contains(event.name()));
            begin(timers, kept, atNanos);
        }
    }

    /** Begins the visit that was prepared. */
    void enter(State state, Outputs out) {
        number++;
        over = false;
        out.enter(number, state, by, inOrder());
    }

    /**
     * Continues the visit in {@code state} of other models.
     *
     * @param left the deadlines of timers that continue
     * @param kept the names of those, fired or not
     */
    void proceed(
            State state,
            @Nullable Transition leading,
            Map<Event, Long> left,
            Set<String> kept,
            Rules rules,
            long atNanos) {
        by = leading;
        deadlines.clear();
        deadlines.putAll(left);
        begin(rules.timers().of(state), kept, atNanos);
    }

    private void begin(Map<Event, Duration> timers, Set<String> kept, long atNanos) {
        timers.forEach((event, delay) -> {
            // A kept timer without a deadline has already fired.
            if (!kept.contains(event.name())) {
                deadlines.put(event, atNanos + delay.toNanos());
            }
        });
    }

    /** When the timers are due, in the order in which they were set. */
    Map<Event, Long> inOrder() {
        return deadlines.isEmpty() ? Map.of() : Collections.unmodifiableMap(new LinkedHashMap<>(deadlines));
    }

    /** Whether a timer of this visit is due and has not fired yet. */
    boolean isDue(Event event, long atNanos) {
        Long deadline = deadlines.get(event);
        return deadline != null && deadline - atNanos <= 0;
    }

    void heard(Event timer) {
        deadlines.remove(timer);
    }
}
