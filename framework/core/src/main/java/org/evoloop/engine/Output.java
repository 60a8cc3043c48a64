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
 * An output of the {@link Core}: something to do now ({@link Directive}), or something to report ({@link Notice}).
 *
 * <p>Threading: immutable.
 *
 * @since 0.1
 */
public sealed interface Output {

    /** The only instance of {@link Leave} needed. */
    Leave LEAVE = new Leave();

    /** Something to be done, in order, by the thread that carries out the occurrence in progress. */
    sealed interface Directive extends Output {}

    /** Something to be reported. */
    sealed interface Notice extends Output {}

    /** An occurrence has its turn: it is to be analyzed and planned. */
    record Begin(Pending pending) implements Output {}

    /** The state entered last is about to be left: end its timers and its function. */
    record Leave() implements Directive {}

    /**
     * Send this step when the device is ready for it; report when sending begins and when the step has had its effect.
     */
    record Send(Step step) implements Directive {}

    /** Run this effect. */
    record Run(String effect) implements Directive {}

    /** Ask the device where it is. */
    record Locate() implements Directive {}

    /**
     * A state is entered.
     *
     * @param by the new model's transition that led here, which determines the function; null if none did
     * @param deadlines when its timers are due
     */
    record Enter(long visit, State state, @Nullable Transition by, Map<Event, Long> deadlines) implements Directive {}

    /**
     * The visit continues in a state of other models.
     *
     * @param deadlines when its timers are due from now on
     */
    record CarryOver(long visit, State state, Map<Event, Long> deadlines) implements Directive {}

    /** An occurrence has been handled; set up what the device needs in these states. */
    record Settle(Configuration now) implements Directive {}

    /**
     * Start the function of the entered state.
     *
     * @param again whether the state was entered again because the attempt to leave it failed
     */
    record Start(long visit, boolean again) implements Directive {}

    /** It waits for its turn. */
    record Queued(Occurrence occurrence) implements Notice {}

    /** It is lost, since the queue is full; {@code first} if it is the first since there was last room. */
    record Dropped(Occurrence occurrence, boolean first) implements Notice {}

    /** It is refused: the converter is closed. */
    record Refused(Occurrence occurrence) implements Notice {}

    /** The occurrence in progress has been decided, and its plan begins. */
    record Decided(Pending pending, Decision decision, long waitedNanos) implements Notice {}

    /** The plan was overtaken by what the device did; the occurrence is decided again. */
    record Overtaken(Occurrence occurrence, String why) implements Notice {}

    /** A step has had its effect. */
    record Took(Step step) implements Notice {}

    /** The record of the states of device and evolved system has changed. */
    record Moved(Configuration before, Configuration after) implements Notice {}

    /** Whether the record is in doubt has changed; {@code why} is empty if it no longer is. */
    record Doubted(String why) implements Notice {}

    /**
     * Other models have taken over: outputs from now on are in their terms.
     *
     * @param before the states before, in terms of the old models
     */
    record Evolved(Occurrence.Evolved occurrence, Configuration before, Fate.Maps fate) implements Notice {}

    /**
     * An occurrence has ended.
     *
     * @param decision its decision; null if it was not decided
     * @param detail why it had no effect, or what went wrong; empty if the decision is explanation enough
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
