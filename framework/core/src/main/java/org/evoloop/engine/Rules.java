package org.evoloop.engine;

import java.time.Duration;
import java.util.List;
import java.util.function.Predicate;
import org.evoloop.evolution.Configuration;
import org.evoloop.evolution.Decision;
import org.evoloop.evolution.DecisionTable;
import org.evoloop.evolution.Occurrence;
import org.evoloop.evolution.Timers;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.State;

/**
 * The rules of a {@link Core}: the models with their decisions, the timers of states, and how many presses may wait, and
 * how long.
 *
 * <p>Threading: immutable; {@code timers} must be a pure function.
 *
 * @param timers the timers of each state
 * @param queueCapacity how many events of controllers may wait behind the one in progress
 * @param pressAge how old such an event may be when its turn comes; an older one is stale
 * @since 0.1
 */
public record Rules(DecisionTable table, Timers timers, int queueCapacity, Duration pressAge) {
    /** A capacity with which not even facts, and events of timers and functions, have room. */
    public static final int NO_ROOM = -Mailbox.MOST_FACTS;

    /** Longer than any time: no event of a controller is ever too old. */
    public static final Duration ANY_AGE = Duration.ofNanos(Long.MAX_VALUE);

    /** Rules by which no event of a controller is ever too old. */
    public Rules(DecisionTable table, Timers timers, int queueCapacity) {
        this(table, timers, queueCapacity, ANY_AGE);
    }

    /**
     * The decision for an occurrence that has its turn: a pure function.
     *
     * @param at the states of device and evolved system
     * @param steps how many steps have been sent so far
     * @param holds whether the guard of this text holds now
     */
    public Decision decide(Configuration at, long steps, Pending pending, Predicate<String> holds) {
        Decision usual = usual(at, steps, pending, holds);
        return pending.broken() == null ? usual : table.afterFailure(usual, at, pending.broken());
    }

    private Decision usual(Configuration at, long steps, Pending pending, Predicate<String> holds) {
        Occurrence occurrence = pending.occurrence();
        State from = pending.from();
        if (occurrence instanceof Occurrence.Heard heard) {
            return from == null
                    ? table.decide(at, table.resolve(at, heard.event(), holds), false)
                    : follow(at, at.withOriginal(from), heard.event(), pending, steps == pending.stepsBefore(), holds);
        }
        if (occurrence instanceof Occurrence.Found) {
            return table.find(from == null ? at : at.withOriginal(from), at.original());
        }
        if (occurrence instanceof Occurrence.Asked asked) {
            return table.ask(at, asked.event(), holds);
        }
        return occurrence instanceof Occurrence.Evolved ? table.settle(at) : new Decision.Inquiry(at);
    }

    /** The new model's decision on a fact: it is in the table, unless the device has moved on since. */
    private Decision follow(
            Configuration at,
            Configuration before,
            Event event,
            Pending pending,
            boolean byItself,
            Predicate<String> holds) {
        Decision known = table.decide(before, table.resolve(before, event, holds), true);
        return known.startsIn(at) ? known : table.react(at, table.resolve(at, event, holds), pending.own(), byItself);
    }

    /**
     * Whether {@code pending} is a press too old to be begun. What the new model defers somewhere may wait, because the
     * model says so; what is urgent is never too old; a plan that has failed in the middle still ends as it should.
     */
    boolean isTooOld(Pending pending, long nowNanos) {
        return pending.mayBeLost()
                && pending.broken() == null
                && !isUrgent(pending)
                && nowNanos - pending.occurrence().observedNanos() > pressAge.toNanos()
                && !(pending.occurrence() instanceof Occurrence.Heard heard && table.mayDefer(heard.event()));
    }

    /** Whether it is an event that a model declares {@linkplain org.evoloop.statemachine.StateMachine#urgent urgent}. */
    boolean isUrgent(Pending pending) {
        return table.models().hasUrgent()
                && pending.occurrence() instanceof Occurrence.Heard heard
                && table.models().isUrgent(heard.event());
    }

    /** How many facts, and events raised by timers or functions, may wait besides controllers' events. */
    public int mostFacts() {
        return queueCapacity + Mailbox.MOST_FACTS;
    }

    /** Whether the event of a timer may wait behind these. */
    public boolean hasRoomForTimer(List<Pending> waiting) {
        return waiting.size() < mostFacts()
                || waiting.stream().filter(pending -> !pending.mayBeLost()).count() < mostFacts();
    }

    /** A copy with other decisions. */
    public Rules with(DecisionTable newTable) {
        return new Rules(newTable, timers, queueCapacity, pressAge);
    }
}
