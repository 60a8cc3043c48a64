package org.evoloop.engine;

import java.util.List;
import org.evoloop.evolution.Decision;
import org.evoloop.evolution.Occurrence;
import org.jspecify.annotations.Nullable;

/**
 * The occurrence in progress: its decision, and how far its plan has been carried out.
 *
 * <p>Threading: immutable.
 *
 * @param decision null while it is being analyzed and planned
 * @param taken how many steps of the decision have been taken
 * @param effectsRun how many of its effects have been run
 * @param failedEffects their failures; empty if there were none
 * @param stage what the plan is waiting for
 * @param meanwhile what the device did by itself while the step was being sent, or while it was asked for its state
 * @since 0.1
 */
public record Work(
        Pending pending,
        @Nullable Decision decision,
        int taken,
        int effectsRun,
        String failedEffects,
        Stage stage,
        List<Occurrence> meanwhile) {

    /** What the occurrence in progress is waiting for. */
    public enum Stage {
        /** A decision, or the start of the requested directive. */
        READY,
        /** The next step is being sent to the device. */
        SENDING,
        /** The next effect is being run. */
        RUNNING,
        /** The process that carried out the plan has ended; it continues when the converter is opened. */
        INTERRUPTED,
        /** The plan has its turn again. */
        RESUMED
    }

    /** Whether the next step is being sent to the device. */
    public boolean sending() {
        return stage == Stage.SENDING;
    }

    /** How many of the decision's steps have been sent and have had their effect. */
    public int stepsSent() {
        return stepsSent(decision, taken);
    }

    /** Of {@code taken} steps, those that the device did not take by itself. */
    static int stepsSent(@Nullable Decision decision, int taken) {
        return decision != null && decision.deviceBegan() ? taken - 1 : taken;
    }

    Work later(long nanos) {
        return new Work(
                pending.later(nanos),
                decision,
                taken,
                effectsRun,
                failedEffects,
                stage,
                Reframed.later(meanwhile, nanos));
    }
}
