package org.evoloop.core;

import java.util.Map;
import org.evoloop.evolution.Configuration;
import org.evoloop.evolution.Decision;
import org.evoloop.evolution.Occurrence;
import org.evoloop.evolution.Step;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.State;
import org.evoloop.statemachine.Transition;
import org.jspecify.annotations.Nullable;

/**
 * Who hears what the {@link Core} says, in order. Every {@link Output} can be heard as a value, by {@link #say}, or by the
 * method of its name, which leaves no garbage in an event's way.
 */
@FunctionalInterface
public interface Outputs {
    /** Hears one output; what it means stands with its record. */
    void say(Output output);

    default void begin(Pending pending) {
        say(new Output.Begin(pending));
    }

    default void leave() {
        say(Output.LEAVE);
    }

    default void send(Step step) {
        say(new Output.Send(step));
    }

    default void run(String effect) {
        say(new Output.Run(effect));
    }

    default void locate() {
        say(new Output.Locate());
    }

    default void enter(long visit, State state, @Nullable Transition by, Map<Event, Long> deadlines) {
        say(new Output.Enter(visit, state, by, deadlines));
    }

    default void settle(Configuration now) {
        say(new Output.Settle(now));
    }

    default void start(long visit) {
        say(new Output.Start(visit));
    }

    default void queued(Occurrence occurrence) {
        say(new Output.Queued(occurrence));
    }

    default void dropped(Occurrence occurrence, boolean first) {
        say(new Output.Dropped(occurrence, first));
    }

    default void refused(Occurrence occurrence) {
        say(new Output.Refused(occurrence));
    }

    default void decided(Pending pending, Decision decision, long waitedNanos) {
        say(new Output.Decided(pending, decision, waitedNanos));
    }

    default void overtaken(Occurrence occurrence, String why) {
        say(new Output.Overtaken(occurrence, why));
    }

    default void took(Step step) {
        say(new Output.Took(step));
    }

    default void moved(Configuration before, Configuration after) {
        say(new Output.Moved(before, after));
    }

    default void doubted(String why) {
        say(new Output.Doubted(why));
    }

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
