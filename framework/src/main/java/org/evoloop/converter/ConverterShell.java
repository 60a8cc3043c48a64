package org.evoloop.converter;

import java.util.List;
import java.util.Locale;
import org.evoloop.core.Outcome;
import org.evoloop.core.Output;
import org.evoloop.core.Rules;
import org.evoloop.core.Tally;
import org.evoloop.evolution.Configuration;
import org.evoloop.evolution.Decision;
import org.evoloop.evolution.DecisionTable;
import org.evoloop.evolution.Occurrence;
import org.evoloop.loop.Failure;
import org.evoloop.loop.LoopConfig;
import org.evoloop.loop.LoopListener;
import org.evoloop.loop.MapeLoop;
import org.evoloop.statemachine.Event;
import org.jspecify.annotations.Nullable;

/**
 * What stands around the core of a converter that runs: the loop that brings its inputs, those who carry its directives
 * out, and the books that are kept of what it says.
 *
 * <p>Threading: the loop calls it for one event at a time; whoever drives the core tells it what the core says.
 */
final class ConverterShell implements LoopListener<Occurrence>, CoreDriver.Listener {
    private final LoopConfig config;
    private final Transcript transcript = new Transcript();
    private final FailureLog failures = new FailureLog();
    final StateKnowledge knowledge;
    final History history;
    final LatencyWindow latency = new LatencyWindow();
    final MapeLoop<Occurrence, Analysis, ChangePlan> loop;
    final Visits visits;
    final CoreDriver driver;
    final Carrier carrier;
    final Listeners listeners;

    /** What came last, if neither model knows it. */
    private @Nullable Event unknown;

    ConverterShell(LoopConfig config, StateKnowledge knowledge, DecisionTable table, Listeners listeners) {
        this.config = config;
        this.knowledge = knowledge;
        this.listeners = listeners;
        this.history = new History(config.clock());
        this.driver = new CoreDriver(
                new Rules(table, knowledge::timersOf, config.queueCapacity()), config.clock(), knowledge, this);
        this.visits = new Visits(config, knowledge, transcript, failures);
        this.carrier = new Carrier(driver, visits, knowledge.bindings(), failures, transcript);
        this.loop = new MapeLoop<>(config, this, carrier::next, driver);
        visits.attach(loop);
        knowledge.attach(driver);
    }

    /** From the next event on, decides by {@code table}. */
    void use(DecisionTable table, List<EventExecute> present) {
        driver.use(table);
        carrier.use(present);
    }

    /** Opens the loop, after every execute component has seen to what the device needs in the current state. */
    void start() {
        for (EventExecute execute : carrier.executes()) {
            try {
                execute.settled(driver.configuration());
            } catch (Exception cause) {
                failed(execute, "settled", cause);
            }
        }
        loop.start(carrier::carryOut);
    }

    /** Whether the caller is a component, a function or the clock, for which nobody must wait who was called by them. */
    boolean ownsCurrentThread() {
        return loop.ownsCurrentThread()
                || visits.ownsCurrentThread()
                || config.clock().ownsCurrentThread();
    }

    /** Ends the current visit and lets go of the device; the loop is closed. */
    void release() {
        driver.release();
        carrier.carryOut();
        for (EventExecute execute : carrier.executes()) {
            try {
                execute.released();
            } catch (Exception cause) {
                failed(execute, "released", cause);
            }
        }
    }

    /** Outside of the loop, on the thread of whoever opens or closes it. */
    private void failed(EventExecute execute, String phase, Exception cause) {
        if (cause instanceof InterruptedException) {
            Thread.currentThread().interrupt();
        } else {
            report(new Failure<>(execute.name(), phase, 0, null, cause));
        }
    }

    private void report(Failure<Occurrence> failure) {
        failures.log(failure);
        listeners.failed(failure);
    }

    ConverterStatus.EventCounts counts() {
        Tally tally = driver.tally();
        return new ConverterStatus.EventCounts(tally.handled(), tally.ignored(), tally.stale(), tally.failed());
    }

    // LoopListener

    @Override
    public void failed(Failure<Occurrence> failure) {
        ends(failure, false);
    }

    @Override
    public void givenUp(Failure<Occurrence> failure) {
        ends(failure, true);
    }

    private void ends(Failure<Occurrence> failure, boolean givenUp) {
        report(failure);
        if (failure.occurrence() != null) {
            driver.failed(failure.toString(), givenUp);
            carrier.carryOut();
        }
    }

    @Override
    public void dropped(Occurrence occurrence, boolean first) {
        if (first) {
            failures.warn("the queue of " + config.queueCapacity()
                    + " events is full, and events are lost; status counts them, history names them");
        }
    }

    // What the core says

    @Override
    public void heard(Output output) {
        if (output instanceof Output.Begin begin) {
            transcript.observed(begin.pending().occurrence());
        } else if (output instanceof Output.Decided decided) {
            transcript.decided(decided.decision());
            latency.record(decided.waitedNanos());
        } else if (output instanceof Output.Send send) {
            transcript.step(send.step());
        } else if (output instanceof Output.Took took) {
            transcript.command(took.step().trigger());
        } else if (output instanceof Output.Ended ended) {
            record(ended);
        } else if (output instanceof Output.Overtaken overtaken) {
            transcript.ended(overtaken.occurrence(), driver.configuration());
        } else if (output instanceof Output.Dropped dropped) {
            Configuration now = driver.configuration();
            history.record(dropped.occurrence(), now, now, Outcome.DROPPED, null, "the queue was full");
            listeners.ended(history);
        } else if (output instanceof Output.Moved moved) {
            listeners.moved(moved.before(), moved.after());
        } else if (output instanceof Output.Doubted doubted) {
            if (!doubted.why().isEmpty()) {
                failures.warn("the state of the device is in doubt: " + doubted.why());
            }
            listeners.doubted(doubted.why());
        }
    }

    private void record(Output.Ended ended) {
        if (ended.decision() instanceof Decision.Impossible impossible) {
            failures.warn(ended.occurrence() + " in " + ended.before() + ": " + impossible.reason());
        }
        if (ended.occurrence() instanceof Occurrence.Heard heard) {
            warnOfUnknown(heard);
        } else if (ended.occurrence() instanceof Occurrence.Found && ended.outcome() == Outcome.FAILED) {
            failures.warn(ended.detail());
        }
        transcript.ended(ended.occurrence(), ended.after());
        history.record(
                ended.occurrence(), ended.before(), ended.after(), ended.outcome(), ended.decision(), ended.detail());
        listeners.ended(history);
    }

    /** An event that neither model knows is told once a burst: until another one comes. */
    private void warnOfUnknown(Occurrence.Heard heard) {
        if (knowledge.eventNames().knows(heard.event())) {
            unknown = null;
        } else if (!heard.event().equals(unknown)) {
            unknown = heard.event();
            failures.warn(knowledge.eventNames().unknown(heard.event()) + " ("
                    + heard.source().name().toLowerCase(Locale.ROOT) + ")");
        }
    }
}
