package org.evoloop.study.proof;

import java.util.List;
import org.evoloop.evolution.Decision;
import org.evoloop.evolution.Step;

/** Decisions as numbers: kind, whether the state is left, the new model's next state, and the events to be sent. */
final class Codes {
    private static final int MOST_STEPS = 4;

    private Codes() {}

    /** As {@code prism/proof/core.pml} reads it. */
    static int of(Decision decision, EvolvingPair evolution) {
        int code = kind(decision);
        code |= decision.leavesState() ? 1 << 3 : 0;
        code |= evolution.number(decision.after().evolved(), false) << 4;
        List<Step> steps =
                decision.steps().stream().filter(step -> !step.byDevice()).toList();
        if (steps.size() > MOST_STEPS) {
            throw new IllegalArgumentException("a plan has more than " + MOST_STEPS + " steps: " + steps);
        }
        for (int index = 0; index < steps.size(); index++) {
            code |= evolution.number(steps.get(index).trigger()) << (8 + 4 * index);
        }
        return code | (decision.transition() == null ? 0 : 1 << 24);
    }

    private static int kind(Decision decision) {
        if (decision instanceof Decision.ExistingState) {
            return 1;
        } else if (decision instanceof Decision.NewState) {
            return 2;
        } else if (decision instanceof Decision.Impossible) {
            return 3;
        } else if (decision instanceof Decision.Sending) {
            return 4;
        } else if (decision instanceof Decision.Inquiry) {
            return 5;
        }
        return decision instanceof Decision.Resynchronization ? 6 : 0;
    }
}
