package org.evoloop.engine;

import java.util.Map;
import org.evoloop.evolution.Configuration;
import org.evoloop.evolution.Decision;
import org.evoloop.evolution.Occurrence;
import org.evoloop.evolution.Outcome;
import org.evoloop.evolution.Step;
import org.evoloop.migration.Fate;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.State;
import org.evoloop.statemachine.Transition;
import org.jspecify.annotations.Nullable;

/**
 * Receives the outputs of a {@link Core}, in order. Every {@link Output} can be received as a value, in {@link #say},
 * or in the method of the same name, which allocates nothing.
 *
 * @since 0.1
 */
@FunctionalInterface
public interface Outputs {
    /** Receives one output; its record describes the meaning. */
    void say(Output output);

    /**
     * The device has acted by itself. This is a remark about an input and no output, so {@link #say} does not get it; the same
     * holds for {@link #reported}.
     *
     * @param from where the record had it before
     * @param own the step that its model has for that; null if it has none
     */
    default void acted(Occurrence.Heard fact, State from, @Nullable Step own) {}

    /**
     * The device has said where it is.
     *
     * @param state a state of its model
     * @param recorded where the record had it
     */
    default void reported(State state, State recorded) {}

    /** As {@link Output.Begin}. */
    default void begin(Pending pending) {
        say(new Output.Begin(pending));
    }

    /** As {@link Output.Leave}. */
    default void leave() {
        say(Output.LEAVE);
    }

    /** As {@link Output.Send}. */
    default void send(Step step) {
        say(new Output.Send(step));
    }

    /** As {@link Output.Run}. */
    default void run(String effect) {
        say(new Output.Run(effect));
    }

    /** As {@link Output.Locate}. */
    default void locate() {
        say(new Output.Locate());
    }

    /** As {@link Output.Enter}. */
    default void enter(long visit, State state, @Nullable Transition by, Map<Event, Long> deadlines) {
        say(new Output.Enter(visit, state, by, deadlines));
    }

    /** As {@link Output.CarryOver}. */
    default void carryOver(long visit, State state, Map<Event, Long> deadlines) {
        say(new Output.CarryOver(visit, state, deadlines));
    }

    /** As {@link Output.Settle}. */
    default void settle(Configuration now) {
        say(new Output.Settle(now));
    }

    /** As {@link Output.Start}. */
    default void start(long visit, boolean again) {
        say(new Output.Start(visit, again));
    }

    /** As {@link Output.Queued}. */
    default void queued(Occurrence occurrence) {
        say(new Output.Queued(occurrence));
    }

    /** As {@link Output.Dropped}. */
    default void dropped(Occurrence occurrence, boolean first) {
        say(new Output.Dropped(occurrence, first));
    }

    /** As {@link Output.Refused}. */
    default void refused(Occurrence occurrence) {
        say(new Output.Refused(occurrence));
    }

    /** As {@link Output.Decided}; the wait is in nanoseconds. */
    default void decided(Pending pending, Decision decision, long waitedNanos) {
        say(new Output.Decided(pending, decision, waitedNanos));
    }

    /** As {@link Output.Overtaken}. */
    default void overtaken(Occurrence occurrence, String why) {
        say(new Output.Overtaken(occurrence, why));
    }

    /** As {@link Output.Took}. */
    default void took(Step step) {
        say(new Output.Took(step));
    }

    /** As {@link Output.Moved}. */
    default void moved(Configuration before, Configuration after) {
        say(new Output.Moved(before, after));
    }

    /** As {@link Output.Doubted}. */
    default void doubted(String why) {
        say(new Output.Doubted(why));
    }

    /** As {@link Output.Evolved}. */
    default void evolved(Occurrence.Evolved occurrence, Configuration before, Fate.Maps fate) {
        say(new Output.Evolved(occurrence, before, fate));
    }

    /** As {@link Output.Ended}. */
    default void ended(
            Occurrence occurrence,
            Configuration before,
            Configuration after,
            Outcome outcome,
            @Nullable Decision decision,
            String detail) {
        say(new Output.Ended(occurrence, before, after, outcome, decision, detail));
    }
}
