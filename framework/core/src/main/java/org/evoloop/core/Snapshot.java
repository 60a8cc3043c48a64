package org.evoloop.core;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.evoloop.evolution.Configuration;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.Transition;
import org.jspecify.annotations.Nullable;

/**
 * Everything that a {@link Core} knows at one moment, but for its rules. A core that is made from it goes on exactly as the
 * one that it was taken of.
 *
 * <p>Threading: immutable.
 *
 * @param open whether controllers' events are taken
 * @param at where the device and the evolved system are
 * @param doubt why that may be wrong; null if it is sure
 * @param steps how many steps have been sent and have had their effect
 * @param lastStepNanos when the last of them had
 * @param visit the visit of the current state
 * @param waiting what waits for its turn, first come first
 * @param losing whether something was lost since there was room
 * @param followOwed whether facts were lost, so that the new model has to follow the device when nothing waits any more
 * @param work the occurrence in progress; null if there is none
 * @param tally how many occurrences came and what became of them
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
     * @param over whether what ran in it has ended, so that another must begin
     * @param by the transition that led into the state; null if none did
     * @param deadlines when its timers are due, those that were not heard yet
     */
    public record OpenVisit(
            long number, boolean over, @Nullable Transition by, Map<Event, Long> deadlines) {}

    /** The same on a clock that shows {@code nanos} more: every time in it is so much later. */
    public Snapshot later(long nanos) {
        Map<Event, Long> deadlines = new LinkedHashMap<>();
        visit.deadlines().forEach((timer, due) -> deadlines.put(timer, due + nanos));
        return new Snapshot(
                open,
                at,
                doubt == null ? null : doubt.later(nanos),
                steps,
                lastStepNanos + nanos,
                new OpenVisit(visit.number(), visit.over(), visit.by(), deadlines),
                waiting.stream().map(pending -> pending.later(nanos)).toList(),
                losing,
                followOwed,
                work == null ? null : work.later(nanos),
                tally,
                nowNanos + nanos);
    }
}
