package org.evoloop.engine;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Function;
import java.util.function.Predicate;
import org.evoloop.evolution.Occurrence;
import org.jspecify.annotations.Nullable;

/**
 * The queue of occurrences and their counts. What the device did by itself is heard before any request, and a recovery
 * from a failed plan comes before that; of the requests, those that are urgent come first; apart from this, first come
 * first served.
 *
 * <p>Only events of controllers take up its capacity; when it is used up, further ones are lost. Facts, and events that
 * a timer or a function raises, have places of their own, {@value #MOST_FACTS} more; as many are for urgent events only. Events that the present state defers
 * may wait for long, so they never take up the places of those that need not wait for another state, among which may be
 * the one that leads there.
 */
final class Mailbox {
    /**
     * How many more places than the capacity there are for facts, and for events of timers and functions; and how many
     * there are for urgent events.
     */
    static final int MOST_FACTS = 1024;

    private final ArrayDeque<Pending> waiting = new ArrayDeque<>();
    private final Counts counts;
    private final Predicate<Pending> deferred;
    private final Predicate<Pending> urgent;

    /** How many of those that wait are urgent; they are not counted among the others. */
    private int urgents;

    /** How many of those that wait may be lost. */
    private int losable;

    /** How many of those that wait are facts, or about one. */
    private int facts;

    /** Whether anything has been lost since there was last room. */
    private boolean losing;

    /**
     * @param deferred whether the present state defers an occurrence
     * @param urgent whether an occurrence is urgent
     */
    Mailbox(Snapshot snapshot, Counts counts, Predicate<Pending> deferred, Predicate<Pending> urgent) {
        this.counts = counts;
        this.deferred = deferred;
        this.urgent = urgent;
        restore(snapshot);
    }

    void restore(Snapshot snapshot) {
        clear();
        snapshot.waiting().forEach(pending -> {
            waiting.add(pending);
            countIn(pending);
        });
        losing = snapshot.losing();
    }

    private void clear() {
        waiting.clear();
        losable = 0;
        facts = 0;
        urgents = 0;
    }

    private void countIn(Pending pending) {
        count(pending, 1);
    }

    private void countOut(Pending pending) {
        count(pending, -1);
    }

    private void count(Pending pending, int by) {
        if (pending.hasHappened()) {
            facts += by;
        }
        if (urgent.test(pending)) {
            urgents += by;
        } else if (pending.mayBeLost()) {
            losable += by;
        }
    }

    /** Whether {@code next} may wait, too. */
    boolean hasRoom(Pending next, Rules rules, boolean idle) {
        if (urgent.test(next)) {
            return urgents < MOST_FACTS;
        }
        return next.mayBeLost() ? hasPlace(next, losable, rules, idle) : others() < rules.mostFacts();
    }

    /** Whether a function need not wait with {@code next}. It must not use up the places of facts. */
    boolean hasRoomForFunction(Pending next, Rules rules, boolean idle) {
        return urgent.test(next) ? urgents < MOST_FACTS : hasPlace(next, others(), rules, idle);
    }

    /** @param alike how many wait that are lost as {@code next} is, or are not */
    private boolean hasPlace(Pending next, int alike, Rules rules, boolean idle) {
        int places = places(rules, idle);
        return alike < places || rivals(next) < places;
    }

    /** How many wait for the places that {@code next} may take. */
    private int rivals(Pending next) {
        boolean waitsForAnotherState = deferred.test(next);
        int rivals = 0;
        for (Pending pending : waiting) {
            if (pending.mayBeLost() == next.mayBeLost()
                    && deferred.test(pending) == waitsForAnotherState
                    && !urgent.test(pending)) {
                rivals++;
            }
        }
        return rivals;
    }

    private int others() {
        return waiting.size() - losable - urgents;
    }

    /** If nothing is in progress, the next occurrence need not wait, whatever the capacity. */
    private static int places(Rules rules, boolean idle) {
        return Math.max(rules.queueCapacity(), idle ? 1 : 0);
    }

    void add(Pending pending) {
        waiting.add(pending);
        countIn(pending);
        losing = false;
        counts.queued(waiting.size());
    }

    void addFirst(Pending pending) {
        waiting.addFirst(pending);
        countIn(pending);
        counts.highest(waiting.size());
    }

    /** Puts one that has begun back, before all others but a question to the device, which has to be asked first. */
    void putBack(Pending pending) {
        Pending question = holdsDoubt() ? next() : null;
        addFirst(pending);
        if (question != null) {
            addFirst(question);
        }
    }

    /** Notes that one was lost; true if it is the first since there was last room. */
    boolean lose() {
        boolean first = !losing;
        losing = true;
        return first;
    }

    /** Takes the first occurrence that may have its turn; null if none may. */
    @Nullable
    Pending next() {
        Pending first = first(pending -> true);
        if (first != null) {
            waiting.remove(first);
            countOut(first);
        }
        return first;
    }

    /** The first of these that may have its turn; null if none may. */
    @Nullable
    Pending first(Predicate<Pending> of) {
        Pending head = waiting.peek();
        boolean inOrder = facts == 0 && urgents == 0;
        if (head == null || ((inOrder || head.goesFirst()) && !deferred.test(head) && of.test(head))) {
            return head;
        }
        Pending fact = facts > 0 ? first(Pending::goesFirst, of) : null;
        Pending next = fact == null ? firstUrgent(of) : fact;
        return next == null ? first(pending -> true, of) : next;
    }

    /** Whether anything urgent waits. */
    boolean holdsUrgent() {
        return urgents > 0;
    }

    /** The first urgent one of these that may have its turn; null if none may. */
    @Nullable
    Pending firstUrgent(Predicate<Pending> of) {
        return urgents > 0 ? first(urgent, of) : null;
    }

    private @Nullable Pending first(Predicate<Pending> among, Predicate<Pending> of) {
        for (Pending pending : waiting) {
            if (among.test(pending) && !deferred.test(pending) && of.test(pending)) {
                return pending;
            }
        }
        return null;
    }

    /** Removes everything but facts. */
    List<Pending> withoutFacts() {
        List<Pending> refused = new ArrayList<>();
        waiting.removeIf(pending -> !pending.hasHappened() && refused.add(pending));
        refused.forEach(this::countOut);
        return refused;
    }

    /** Whether the first was begun before, and overtaken. */
    boolean isRetryNext() {
        Pending first = waiting.peek();
        return first != null && first.attempts() > 0;
    }

    boolean holds(long number) {
        for (Pending pending : waiting) {
            if (pending.number() == number) {
                return true;
            }
        }
        return false;
    }

    /** Whether any was begun before, and overtaken. */
    boolean holdsRetry() {
        for (Pending pending : waiting) {
            if (pending.attempts() > 0) {
                return true;
            }
        }
        return false;
    }

    /** Whether any fact waits. */
    boolean holdsFacts() {
        return facts > 0;
    }

    /** Whether other models have taken over, and the device has yet to be sent to where the new model is. */
    boolean holdsTakeover() {
        if (waiting.isEmpty()) {
            return false;
        }
        for (Pending pending : waiting) {
            if (pending.occurrence() instanceof Occurrence.Evolved) {
                return true;
            }
        }
        return false;
    }

    /** Whether a doubt waits to be settled. */
    boolean holdsDoubt() {
        Pending first = waiting.peek();
        return first != null && first.occurrence() instanceof Occurrence.InDoubt;
    }

    /** @param another returns the replacement of each; null to remove it */
    void replace(Function<Pending, @Nullable Pending> another) {
        List<Pending> all = waiting();
        clear();
        for (Pending pending : all) {
            Pending next = another.apply(pending);
            if (next != null) {
                waiting.add(next);
                countIn(next);
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
