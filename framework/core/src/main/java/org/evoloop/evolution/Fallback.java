package org.evoloop.evolution;

import java.util.ArrayList;
import java.util.List;
import org.evoloop.statemachine.Transition;
import org.jspecify.annotations.Nullable;

/**
 * The recovery from one failed step of a plan, as configured by {@link DeviceEvents#onFailure(Transition)}.
 *
 * <p>Threading: immutable.
 *
 * @param failed the step
 * @param then the configured recovery
 * @param way the steps sent then; null if no events that can be sent lead there
 * @since 0.1
 */
public record Fallback(
        Step failed, OnFailure then, @Nullable List<Step> way) {

    /** The fallbacks of a plan, in the order of its steps; none where the device simply stays. */
    public static List<Fallback> of(DecisionTable table, Decision decision) {
        Transition transition = decision.transition();
        OnFailure then = transition == null ? OnFailure.STAY : table.device().onFailure(transition);
        if (transition == null || then == OnFailure.STAY || decision instanceof Decision.Impossible) {
            return List.of();
        }
        List<Fallback> fallbacks = new ArrayList<>();
        for (Step step : decision.steps()) {
            boolean isAway = !step.source().equals(decision.deviceStart());
            if (!step.byDevice() && (isAway || then == OnFailure.OTHER_WAY)) {
                Configuration at = decision.before().withOriginal(step.source());
                Decision usual = table.decide(at, transition.event(), false);
                BrokenPlan broken = new BrokenPlan(then, "", decision.deviceStart(), List.of(step));
                Decision next = table.afterFailure(usual, at, broken);
                boolean isThere = then == OnFailure.GO_BACK
                        ? next.after().original().equals(decision.deviceStart())
                        : !(next instanceof Decision.Impossible);
                fallbacks.add(new Fallback(step, then, isThere ? next.steps() : null));
            }
        }
        return List.copyOf(fallbacks);
    }
}
