package org.evoloop.converter;

import java.util.List;
import java.util.Objects;
import java.util.concurrent.CompletableFuture;
import org.evoloop.converter.attachment.Endings;
import org.evoloop.evolution.Configuration;
import org.evoloop.evolution.Decision;
import org.evoloop.evolution.Outcome;
import org.evoloop.evolution.Step;
import org.evoloop.statemachine.Event;
import org.jspecify.annotations.Nullable;

/**
 * An event on its way into the converter, and the future of its outcome. The reason why it is not taken is known better to
 * who submits it than to the core, and wins.
 *
 * <p>Threading: thread-safe.
 */
final class Submission {
    private static final String OVERTAKEN = "overtaken";

    final CompletableFuture<PressOutcome> outcome = new CompletableFuture<>();
    private boolean taken;
    private Endings.@Nullable Ended early;

    synchronized void ended(Endings.Ended ended) {
        if (taken) {
            outcome.complete(of(ended));
        } else {
            early = ended;
        }
    }

    synchronized void taken() {
        taken = true;
        if (early != null) {
            outcome.complete(of(early));
        }
    }

    void notTaken(PressOutcome why) {
        outcome.complete(why);
    }

    private static PressOutcome of(Endings.Ended ended) {
        Outcome outcome = ended.outcome();
        String why = ended.detail();
        if (outcome == null) {
            return new PressOutcome.Refused(why);
        }
        Configuration before = Objects.requireNonNull(ended.before());
        Configuration after = Objects.requireNonNull(ended.after());
        return switch (outcome) {
            case HANDLED -> new PressOutcome.Handled(before, after, sent(ended.decision()));
            case IGNORED ->
                ended.decision() instanceof Decision.NotAcceptable
                        ? new PressOutcome.NotAcceptable(why)
                        : new PressOutcome.Refused(why);
            case STALE -> new PressOutcome.Stale(why);
            case DROPPED -> new PressOutcome.Dropped(why);
            case FAILED ->
                why.startsWith(OVERTAKEN)
                        ? new PressOutcome.Overtaken(before, after, why)
                        : new PressOutcome.Failed(before, after, why);
        };
    }

    private static List<Event> sent(@Nullable Decision decision) {
        return decision == null
                ? List.of()
                : decision.steps().stream()
                        .filter(step -> !step.byDevice())
                        .map(Step::trigger)
                        .toList();
    }
}
