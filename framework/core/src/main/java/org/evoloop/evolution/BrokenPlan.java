package org.evoloop.evolution;

import java.util.List;
import org.evoloop.statemachine.State;

/**
 * A plan with a failed step that requires more than staying where the device is.
 *
 * <p>Threading: immutable.
 *
 * @param then the recovery, not {@link OnFailure#STAY}
 * @param reason why the last step has failed, for people
 * @param begun the device's state when the plan began
 * @param failed the steps that have failed, in order
 * @since 0.1
 */
public record BrokenPlan(OnFailure then, String reason, State begun, List<Step> failed) {
    public BrokenPlan {
        failed = List.copyOf(failed);
    }
}
