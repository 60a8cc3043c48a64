package org.evoloop.converter.running;

import org.evoloop.engine.Core;
import org.evoloop.engine.Inputs;
import org.evoloop.engine.Pending;
import org.evoloop.engine.Tally;
import org.evoloop.evolution.Occurrence;
import org.evoloop.evolution.Source;
import org.evoloop.loop.Intake;
import org.evoloop.loop.QueueStatus;
import org.evoloop.time.Clock;
import org.jspecify.annotations.Nullable;

/**
 * The queue of the loop, which is in the core.
 *
 * <p>Threading: guarded by the lock of the {@link CoreDriver}.
 */
final class CoreIntake implements Intake<Occurrence> {
    private final CoreDriver driver;
    private final Core core;
    private final Inputs inputs;
    private final CoreOutputs outputs;
    private final Clock clock;
    private final SentryFeed sentryFeed;

    CoreIntake(CoreDriver driver, SentryFeed sentryFeed) {
        this.driver = driver;
        this.core = driver.core;
        this.inputs = driver.inputs;
        this.outputs = driver.outputs;
        this.clock = driver.clock;
        this.sentryFeed = sentryFeed;
    }

    /** @throws IllegalArgumentException if its time is in the future: all timers would be late by as much */
    @Override
    public Admission offer(Occurrence occurrence) {
        synchronized (driver) {
            requireNow(occurrence);
            // The core answers by its outputs, within the call below; the lock keeps the answers of two monitors apart.
            outputs.admission = Admission.TAKEN;
            if (core.isOpen() || occurrence.isFact()) {
                sentryFeed.comes(occurrence, core.at());
            }
            if (occurrence.source() == Source.TIMER && occurrence instanceof Occurrence.Heard timer) {
                inputs.timerDue(timer.visit(), timer.event(), timer.observedNanos());
            } else {
                inputs.observed(occurrence);
            }
            // What an open core refuses is what the journal could not keep.
            boolean unkept = outputs.admission == Admission.REFUSED && core.isOpen();
            return unkept ? Admission.NOT_RECORDED : outputs.admission;
        }
    }

    private void requireNow(Occurrence occurrence) {
        long early = occurrence.observedNanos() - clock.nanoTime();
        if (early > 0) {
            throw new IllegalArgumentException(occurrence + " says that it was observed " + early / 1_000_000
                    + " ms in the future; give it a time of the converter's clock");
        }
    }

    @Override
    public @Nullable Occurrence next() {
        synchronized (driver) {
            // A component that was given up may still hold the last agenda; with nobody's turn it finds nothing to do.
            outputs.begun = null;
            outputs.agenda.begin(Agenda.NOBODY);
            inputs.ready();
            Pending pending = outputs.begun;
            return pending == null ? null : pending.occurrence();
        }
    }

    @Override
    public boolean hasRoom(Occurrence occurrence) {
        synchronized (driver) {
            return core.hasRoom(occurrence);
        }
    }

    @Override
    public void ended() {
        synchronized (driver) {
            Pending pending = outputs.begun;
            // No component has told the core how it ended, and the core would wait for that for ever.
            if (pending != null && core.isBusy()) {
                inputs.dismissed(pending.number(), clock.nanoTime());
            }
            driver.eventEnded();
        }
    }

    @Override
    public void opened() {
        synchronized (driver) {
            outputs.agenda.begin(Agenda.NOBODY);
            inputs.opened(clock.nanoTime());
        }
    }

    @Override
    public void closed() {
        synchronized (driver) {
            inputs.closing();
        }
    }

    @Override
    public QueueStatus status() {
        synchronized (driver) {
            Tally tally = core.tally();
            return new QueueStatus(
                    core.waiting(),
                    driver.rules().queueCapacity(),
                    tally.highest(),
                    tally.queued(),
                    tally.dropped(),
                    tally.refused());
        }
    }
}
