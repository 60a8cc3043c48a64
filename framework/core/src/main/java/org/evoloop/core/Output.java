package org.evoloop.core;

import java.util.Map;
import org.evoloop.evolution.Configuration;
import org.evoloop.evolution.Decision;
import org.evoloop.evolution.Occurrence;
import org.evoloop.evolution.Step;
import org.evoloop.migration.Fate;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.State;
import org.evoloop.statemachine.Transition;
import org.jspecify.annotations.Nullable;

/**
 * What the {@link Core} says: what somebody has to do now ({@link Directive}), and what has become of something
 * ({@link Notice}).
 *
 * <p>Threading: immutable.
 *
 * @since 0.1
 */
public sealed interface Output {

    /** The one {@link Leave} that there has to be. */
    Leave LEAVE = new Leave();

    /** Something to be done, in order, by the thread that carries the occurrence in progress. */
    sealed interface Directive extends Output {}

    /** Something to be reported. */
    sealed interface Notice extends Output {}

    /** An occurrence has its turn: it is to be analyzed and planned. */
    record Begin(Pending pending) implements Output {}

    /** The state that was entered last will be left: its timers and its function end. */
    record Leave() implements Directive {}

    /** Send this step when the device is ready for it; report when that begins and when it has had its effect. */
    record Send(Step step) implements Directive {}

    /** Run this effect. */
    record Run(String effect) implements Directive {}

    /** Ask the device where it is. */
    record Locate() implements Directive {}

    /**
     * A state is entered.
     *
     * @param by the new model's transition that led here, which names the function; null if none did
     * @param deadlines when its timers are due
     */
    record Enter(long visit, State state, @Nullable Transition by, Map<Event, Long> deadlines) implements Directive {}

    /**
     * The visit goes on in a state of other models.
     *
     * @param deadlines when its timers are due from now on
     */
    record CarryOver(long visit, State state, Map<Event, Long> deadlines) implements Directive {}

    /** An occurrence has been dealt with; the device may be given what it needs in these states. */
    record Settle(Configuration now) implements Directive {}

    /**
     * The function of the state that was entered begins.
     *
     * @param again whether the state was entered again because what should have led out of it has failed
     */
    record Start(long visit, boolean again) implements Directive {}

    /** It waits for its turn. */
    record Queued(Occurrence occurrence) implements Notice {}

    /** It is lost, since the queue is full; {@code first} if that is so for the first time since there was room. */
    record Dropped(Occurrence occurrence, boolean first) implements Notice {}

    /** It is refused: the converter is closed. */
    record Refused(Occurrence occurrence) implements Notice {}

    /** What the occurrence in progress was found to mean, and that its plan begins. */
    record Decided(Pending pending, Decision decision, long waitedNanos) implements Notice {}

    /** The plan was overtaken by what the device did; the occurrence is decided anew. */
    record Overtaken(Occurrence occurrence, String why) implements Notice {}

    /** A step has had its effect. */
    record Took(Step step) implements Notice {}

    /** The record of where device and evolved system stand has changed. */
    record Moved(Configuration before, Configuration after) implements Notice {}

    /** Whether the record is in doubt has changed; {@code why} is empty if it no longer is. */
    record Doubted(String why) implements Notice {}

    /**
     * Other models have taken over: what is said from now on is in their terms.
     *
     * @param before where device and evolved system were, in terms of the models before
     */
    record Evolved(Occurrence.Evolved occurrence, Configuration before, Fate.Maps fate) implements Notice {}

    /**
     * An occurrence has come to its end, and this is what became of it.
     *
     * @param decision what it meant; null if it did not come so far
     * @param detail why it came to nothing, or what went wrong; empty if the decision says it all
     */
    record Ended(
            Occurrence occurrence,
            Configuration before,
            Configuration after,
            Outcome outcome,
            @Nullable Decision decision,
            String detail)
            implements Notice {}
}
