package org.evoloop.converter;

/**
 * Other models beside those that run: they get the same inputs, none of their decisions is carried out, and what both make of
 * each event is compared. A shadow ends when models take over, when another one begins, and with the process.
 *
 * <p>A step of theirs succeeds unless the running models' step for the same event failed; guards hold that hold for the
 * running models; functions do not run: their events are heard while both new models are in the same state. Timers are due
 * by the other models' own deadlines. What the {@linkplain Probation.Watches watches} of the evolution find in what they
 * make of events is told, too.
 *
 * <p>Threading: thread-safe.
 *
 * @since 0.1
 */
public final class Shadow implements AutoCloseable {
    private final Evolver evolver;
    private final ConverterShell shell;
    private final Evolution evolution;

    Shadow(Evolver evolver, ConverterShell shell, Evolution evolution) {
        this.evolver = evolver;
        this.shell = shell;
        this.evolution = evolution;
    }

    /** By which {@link #promote} puts the models in. */
    public Evolution evolution() {
        return evolution;
    }

    /** How it stands. @throws IllegalStateException if it has ended */
    public ShadowReport report() {
        ShadowReport report = evolver.shadow() == this ? shell.driver.shadowReport() : null;
        if (report == null) {
            throw new IllegalStateException("the shadow has ended");
        }
        return report;
    }

    /**
     * Puts the other models in, as {@link SystemEventConverter#evolve} does: from where the system is, not from where they
     * would have brought it.
     *
     * @throws IllegalStateException if it has ended
     * @throws EvolutionException if it was not possible in time; the shadow stays
     */
    public Evolution.Result promote() {
        return evolver.promote(this, shell);
    }

    /** Ends it, if it has not ended. */
    @Override
    public void close() {
        evolver.end(this, shell);
    }
}
