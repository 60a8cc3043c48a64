package org.evoloop.converter;

/** Learns when what an execute component sends has its effect. */
interface EffectListener {
    /**
     * The step that {@code execute} was sending has had its effect; only the first call for a step counts.
     *
     * @param inOrder whether it is reported in the order in which everything happened at the device
     */
    void tookEffect(EventExecute execute, boolean inOrder);
}
