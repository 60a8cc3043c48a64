package org.evoloop.core;

import java.util.List;
import org.evoloop.evolution.Decision;
import org.evoloop.evolution.Occurrence;
import org.evoloop.evolution.Step;
import org.jspecify.annotations.Nullable;

/**
 * The occurrence in progress: what it means, and how far its plan has been carried out.
 *
 * <p>Threading: immutable.
 *
 * @param decision null while it is being analyzed and planned
 * @param taken how many steps of the decision have been taken
 * @param effectsRun how many of its effects have been run
 * @param failedEffects what went wrong with them; empty if nothing did
 * @param sending whether the next step is on its way to the device
 * @param meanwhile what the device did by itself while the step was on its way, or while it was asked where it is
 */
public record Work(
        Pending pending,
        @Nullable Decision decision,
        int taken,
        int effectsRun,
        String failedEffects,
        boolean sending,
        List<Occurrence> meanwhile) {

    static Work begin(Pending pending) {
        return new Work(pending, null, 0, 0, "", false, List.of());
    }

    Work decided(Decision what) {
        boolean ownFirst = !what.steps().isEmpty() && what.steps().get(0).byDevice();
        return new Work(pending, what, ownFirst ? 1 : 0, 0, "", false, List.of());
    }

    Work sendingNext() {
        return new Work(pending, decision, taken, effectsRun, failedEffects, true, List.of());
    }

    Work tookNext() {
        return new Work(pending, decision, taken + 1, effectsRun, failedEffects, false, List.of());
    }

    Work ranNext(String failure) {
        String failures =
                failure.isEmpty() || failedEffects.isEmpty() ? failedEffects + failure : failedEffects + "; " + failure;
        return new Work(pending, decision, taken, effectsRun + 1, failures, false, List.of());
    }

    Work acted(Occurrence fact) {
        return new Work(pending, decision, taken, effectsRun, failedEffects, sending, Overlap.add(meanwhile, fact));
    }

    Work askingAgain() {
        return new Work(pending.again(), decision, taken, effectsRun, failedEffects, sending, List.of());
    }

    /** The step to be sent next; null if there is none left. */
    public @Nullable Step nextStep() {
        return decision != null && taken < decision.steps().size()
                ? decision.steps().get(taken)
                : null;
    }

    /** The step that is on its way to the device; null if none is. */
    @Nullable
    Step stepOnItsWay() {
        return sending ? nextStep() : null;
    }

    /** The effect to be run next; null if there is none left. */
    public @Nullable String nextEffect() {
        return decision != null && effectsRun < decision.effects().size()
                ? decision.effects().get(effectsRun)
                : null;
    }
}
