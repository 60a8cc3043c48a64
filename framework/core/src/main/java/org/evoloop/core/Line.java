package org.evoloop.core;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Function;
import java.util.function.Predicate;
import org.evoloop.evolution.Occurrence;
import org.jspecify.annotations.Nullable;

/**
 * The queue of occurrences, first come first served, and their counts.
 *
 * <p>Events of controllers are lost when the queue is full. Facts, and events that a timer or a function raises, are
 * lost only when {@value #MOST_FACTS} more wait.
 */
final class Line {
    /** How many more than the capacity may wait if they must not be lost. */
    static final int MOST_FACTS = 1024;

    private final ArrayDeque<Pending> waiting = new ArrayDeque<>();
    private final Counts counts;

    /** Whether anything has been lost since there was last room. */
    private boolean losing;

    Line(Snapshot snapshot, Counts counts) {
        this.counts = counts;
        restore(snapshot);
    }

    void restore(Snapshot snapshot) {
        waiting.clear();
        waiting.addAll(snapshot.waiting());
        losing = snapshot.losing();
    }

    /** Whether one more event of a controller may wait; if nothing is in progress it need not wait at all. */
    boolean hasRoom(int capacity, boolean idle) {
        return waiting.size() < Math.max(capacity, idle ? 1 : 0);
    }

    boolean hasRoomForFacts(Rules rules) {
        return waiting.size() < rules.mostWaiting();
    }

    void add(Pending pending) {
        waiting.add(pending);
        losing = false;
        counts.queued(waiting.size());
    }

    void addFirst(Pending pending) {
        waiting.addFirst(pending);
        counts.highest(waiting.size());
    }

    /** Notes that one was lost; true if it is the first since there was last room. */
    boolean lose() {
        boolean first = !losing;
        losing = true;
        return first;
    }

    /** The first occurrence that may have its turn; null if none may. */
    @Nullable
    Pending next(Predicate<Pending> deferred) {
        Pending first = waiting.peek();
        if (first == null || !deferred.test(first)) {
            return waiting.poll();
        }
        for (Pending pending : waiting) {
            if (!deferred.test(pending)) {
                waiting.remove(pending);
                return pending;
            }
        }
        return null;
    }

    /** Removes everything but facts. */
    List<Pending> withoutFacts() {
        List<Pending> refused = new ArrayList<>();
        waiting.removeIf(pending -> !pending.hasHappened() && refused.add(pending));
        return refused;
    }

    /** Whether the first was begun before, and overtaken. */
    boolean isRetryNext() {
        Pending first = waiting.peek();
        return first != null && first.attempts() > 0;
    }

    /** Whether a doubt waits to be settled. */
    boolean holdsDoubt() {
        Pending first = waiting.peek();
        return first != null && first.occurrence() instanceof Occurrence.InDoubt;
    }

    /** @param another returns the replacement of each; null to remove it */
    void replace(Function<Pending, @Nullable Pending> another) {
        List<Pending> all = waiting();
        waiting.clear();
        for (Pending pending : all) {
            Pending next = another.apply(pending);
            if (next != null) {
                waiting.add(next);
            }
        }
    }

    int size() {
        return waiting.size();
    }

    boolean isLosing() {
        return losing;
    }

    List<Pending> waiting() {
        return List.copyOf(waiting);
    }
}
