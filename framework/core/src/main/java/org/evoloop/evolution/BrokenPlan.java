package org.evoloop.evolution;

import java.util.List;
import org.evoloop.statemachine.State;

/**
 * A plan of which a step has failed, and after which more than that is to be done.
 *
 * <p>Threading: immutable.
 *
 * @param then what is to be done, not {@link OnFailure#STAY}
 * @param reason why the last step has failed, for people
 * @param begun where the device was when the plan began
 * @param failed the steps that have failed, in order
 * @since 0.1
 */
public record BrokenPlan(OnFailure then, String reason, State begun, List<Step> failed) {
    public BrokenPlan {
        failed = List.copyOf(failed);
    }
}
