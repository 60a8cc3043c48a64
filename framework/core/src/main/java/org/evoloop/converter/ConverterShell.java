package org.evoloop.converter;

import java.util.List;
import org.evoloop.core.Rules;
import org.evoloop.core.Tally;
import org.evoloop.evolution.DecisionTable;
import org.evoloop.evolution.Occurrence;
import org.evoloop.loop.Failure;
import org.evoloop.loop.LoopConfig;
import org.evoloop.loop.LoopListener;
import org.evoloop.loop.MapeLoop;
import org.jspecify.annotations.Nullable;

/**
 * What stands around the core of a converter that runs: the loop that brings its inputs, those who carry its directives
 * out, and the books that are kept of what it says.
 *
 * <p>Threading: the loop calls it for one event at a time.
 */
final class ConverterShell implements LoopListener<Occurrence> {
    private final LoopConfig config;
    final StateKnowledge knowledge;
    final Books books;
    final MapeLoop<Occurrence, Analysis, ChangePlan> loop;
    final Visits visits;
    final CoreDriver driver;
    final Carrier carrier;

    ConverterShell(
            LoopConfig config,
            StateKnowledge knowledge,
            DecisionTable table,
            Listeners listeners,
            @Nullable ConverterJournal journal) {
        this.config = config;
        this.knowledge = knowledge;
        this.books = new Books(config.clock(), listeners);
        this.driver = new CoreDriver(
                new Rules(table, knowledge::timersOf, config.queueCapacity()),
                config.clock(),
                knowledge,
                books,
                journal);
        this.visits = new Visits(config, knowledge, books.transcript(), books.failures());
        this.carrier = new Carrier(driver, visits, knowledge.bindings(), books.failures(), books.transcript());
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
        books.failures().log(failure);
        books.listeners().failed(failure);
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
            books.failures()
                    .warn("the queue of " + config.queueCapacity()
                            + " events is full, and events are lost; status counts them, history names them");
        }
    }
}
