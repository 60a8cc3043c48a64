package org.evoloop.engine;

import java.util.ArrayList;
import java.util.List;
import org.evoloop.evolution.BrokenPlan;
import org.evoloop.evolution.Decision;
import org.evoloop.evolution.OnFailure;
import org.evoloop.evolution.Step;
import org.evoloop.statemachine.State;
import org.evoloop.statemachine.Transition;
import org.jspecify.annotations.Nullable;

/** What follows when a step of the plan in progress fails. */
final class Recovery {
    private Recovery() {}

    /** The broken plan to recover from; null if there is nothing to do, or something urgent goes first. */
    static @Nullable BrokenPlan from(Ledger ledger, String reason) {
        Pending pending = ledger.progress.pending();
        Decision decision = ledger.progress.decision();
        Transition transition = decision == null ? null : decision.transition();
        Step failed = ledger.progress.step();
        boolean mayGoOn = ledger.open && ledger.overtakenBy().isEmpty();
        if (decision == null || transition == null || failed == null || !mayGoOn) {
            return null;
        }
        OnFailure then = ledger.rules.table().device().onFailure(transition);
        BrokenPlan before = pending.broken();
        State begun = before == null ? decision.deviceStart() : before.begun();
        boolean isPossible = switch (then) {
            case STAY -> false;
            case GO_BACK -> !begun.equals(ledger.place.at().original());
            case OTHER_WAY -> pending.attempts() < Conversion.MOST_ATTEMPTS;
        };
        List<Step> all = new ArrayList<>(before == null ? List.of() : before.failed());
        all.add(failed);
        return isPossible ? new BrokenPlan(then, reason, begun, all) : null;
    }
}
