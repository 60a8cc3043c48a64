package org.evoloop.converter.attachment;

import org.evoloop.evolution.Decision;
import org.evoloop.evolution.Occurrence;

/** What an execute component is attached to. */
public interface ExecuteHost {
    /** Carries out the plan for {@code occurrence} as far as {@code execute} can, on its thread. */
    void carryOut(Occurrence occurrence, Decision plan, ExecuteAccess execute) throws Exception;

    /**
     * The step that {@code execute} was sending has had its effect; only the first call for a step counts.
     *
     * @param inOrder whether it is reported in the order in which everything happened at the device
     */
    void tookEffect(ExecuteAccess execute, boolean inOrder);
}
