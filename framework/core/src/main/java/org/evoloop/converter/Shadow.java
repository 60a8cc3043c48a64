package org.evoloop.converter;

/**
 * Other models beside the running ones: they get the same inputs, none of their decisions is carried out, and both
 * decisions on each event are compared. A shadow ends when models take over, when another shadow begins, and with the
 * process.
 *
 * <p>Equal models never differ. Where the other models plan otherwise, a step of theirs succeeds unless the running models'
 * step for the same event failed. A guard holds if it holds for the running models. Functions do not run: their events count
 * while both new models are in the same state. Timers that only the other models have fire when they are due. Violations that the {@linkplain Probation.Watches watches} of the
 * evolution find in the shadow's results are reported, too.
 *
 * <p>Threading: thread-safe.
 *
 * @since 0.1
 */
public interface Shadow extends AutoCloseable {
    /** The evolution that {@link #promote} carries out. */
    Evolution evolution();

    /**
     * The report so far.
     *
     * @throws IllegalStateException if it has ended
     */
    ShadowReport report();

    /**
     * Lets the other models take over, as {@link SystemEventConverter#evolve} does: from the system's present states,
     * not from those to which they would have led.
     *
     * @throws IllegalStateException if it has ended
     * @throws EvolutionException if it was not possible in time; the shadow stays
     */
    Evolution.Result promote();

    /** Ends the shadow. Idempotent. */
    @Override
    void close();
}
