package org.evoloop.engine;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.evoloop.evolution.Configuration;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.Transition;
import org.jspecify.annotations.Nullable;

/**
 * The complete state of a {@link Core} at one moment, except its rules. A core made from it continues exactly as the
 * original.
 *
 * <p>Threading: immutable.
 *
 * @param open whether controllers' events are taken
 * @param at the states of device and evolved system
 * @param doubt why these may be wrong; null if they are certain
 * @param steps how many steps have been sent and have had their effect
 * @param lastStepNanos when the last of them had its effect
 * @param visit the visit of the current state
 * @param waiting the occurrences that wait for their turn, in order
 * @param losing whether anything has been lost since there was last room
 * @param followOwed whether the new model has to follow the device once no fact waits any more, since facts alone do
 *     not lead it there
 * @param work the occurrence in progress; null if there is none
 * @param tally the number of occurrences and their outcomes
 * @param nowNanos the latest time of any input
 * @since 0.1
 */
public record Snapshot(
        boolean open,
        Configuration at,
        @Nullable Doubt doubt,
        long steps,
        long lastStepNanos,
        OpenVisit visit,
        List<Pending> waiting,
        boolean losing,
        boolean followOwed,
        @Nullable Work work,
        Tally tally,
        long nowNanos) {

    /**
     * The visit of a state.
     *
     * @param over whether it has ended, so that another must begin
     * @param by the transition that led into the state; null if none did
     * @param deadlines when its timers are due, without those that have fired
     * @param startOwed whether its function has yet to be started, once the device is known to be where the state needs it
     */
    public record OpenVisit(
            long number, boolean over, @Nullable Transition by, Map<Event, Long> deadlines, boolean startOwed) {

        /** A copy with other deadlines. */
        public OpenVisit withDeadlines(Map<Event, Long> others) {
            return new OpenVisit(number, over, by, others, startOwed);
        }
    }

    /** A copy in which the occurrence that came last has its turn first. */
    public Snapshot lastFirst() {
        List<Pending> order = new ArrayList<>(waiting);
        order.add(0, order.remove(order.size() - 1));
        return new Snapshot(
                open,
                at,
                doubt,
                steps,
                lastStepNanos,
                visit,
                List.copyOf(order),
                losing,
                followOwed,
                work,
                tally,
                nowNanos);
    }

    /** A copy for a clock that is {@code nanos} ahead: every time in it is later by that much. */
    public Snapshot later(long nanos) {
        Map<Event, Long> deadlines = new LinkedHashMap<>();
        visit.deadlines().forEach((timer, due) -> deadlines.put(timer, due + nanos));
        return new Snapshot(
                open,
                at,
                doubt == null ? null : doubt.later(nanos),
                steps,
                lastStepNanos + nanos,
                visit.withDeadlines(deadlines),
                waiting.stream().map(pending -> pending.later(nanos)).toList(),
                losing,
                followOwed,
                work == null ? null : work.later(nanos),
                tally,
                nowNanos + nanos);
    }
}
