package org.evoloop.journal;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.evoloop.core.Outcome;
import org.evoloop.core.Output;
import org.evoloop.core.Outputs;
import org.evoloop.core.text.DecisionKind;
import org.evoloop.evolution.Decision;
import org.evoloop.evolution.Occurrence;

/**
 * Listens to a core, and keeps what became of each event and how.
 *
 * <p>Threading: not thread-safe.
 */
class Chronicle implements Outputs {
    private final Map<EventKey, Ending> endings = new LinkedHashMap<>();
    private final EventKey.Sequence keys = new EventKey.Sequence();
    private List<String> sent = new ArrayList<>();
    private int took;
    private Set<String> guards = Set.of();
    private long visit;

    /**
     * How an event ended.
     *
     * @param took how many steps had had their effect by then
     * @param guards that the decision supposed to hold
     */
    record Ending(Occurrence occurrence, Verdict verdict, int took, Set<String> guards, boolean carriedOut) {
        /** Whether a step failed on the way. */
        boolean isBroken() {
            return verdict.outcome() == Outcome.FAILED && !carriedOut;
        }
    }

    @Override
    public void say(Output output) {
        if (output instanceof Output.Begin) {
            sent = new ArrayList<>();
            took = 0;
            guards = Set.of();
        } else if (output instanceof Output.Send send) {
            sent.add(send.step().trigger().name());
        } else if (output instanceof Output.Took) {
            took++;
        } else if (output instanceof Output.Decided decided) {
            Decision decision = decided.decision();
            guards = decision.transition() == null
                    ? Set.of()
                    : Set.copyOf(decision.transition().event().guards());
        } else if (output instanceof Output.Enter enter) {
            visit = enter.visit();
        } else if (output instanceof Output.Ended ended) {
            end(ended);
        }
    }

    private void end(Output.Ended ended) {
        if (ended.occurrence() instanceof Occurrence.InDoubt) {
            return;
        }
        Decision decision = ended.decision();
        String why = decision == null ? ended.detail() : words(decision);
        Verdict verdict = new Verdict(ended.before(), ended.after(), ended.outcome(), sent, why);
        endings.put(
                keys.take(ended.occurrence()), new Ending(ended.occurrence(), verdict, took, guards, decision != null));
        sent = new ArrayList<>();
    }

    private static String words(Decision decision) {
        String reason = DecisionKind.reasonOf(decision);
        return DecisionKind.of(decision).word() + (reason.isEmpty() ? "" : ", " + reason);
    }

    /** The key of an event that has not ended. */
    EventKey keyOf(Occurrence occurrence) {
        return keys.next(occurrence);
    }

    Map<EventKey, Ending> endings() {
        return endings;
    }

    /** The number of the current visit. */
    long visit() {
        return visit;
    }

    int took() {
        return took;
    }
}
