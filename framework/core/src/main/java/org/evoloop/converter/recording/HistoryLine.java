package org.evoloop.converter.recording;

import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import org.evoloop.converter.HistoryEntry;
import org.evoloop.evolution.Configuration;
import org.evoloop.evolution.Decision;
import org.evoloop.evolution.Occurrence;
import org.evoloop.evolution.Outcome;
import org.evoloop.evolution.Step;
import org.jspecify.annotations.Nullable;

/**
 * A reusable line of the {@link History}, formatted only on demand.
 *
 * <p>Threading: guarded by its history.
 */
final class HistoryLine {
    private long number;
    private @Nullable Instant at;
    private long tookNanos;
    private @Nullable Occurrence occurrence;
    private @Nullable Configuration before;
    private @Nullable Configuration after;
    private @Nullable Outcome outcome;
    private @Nullable Decision decision;
    private String detail = "";
    private String left = "";

    void set(
            long newNumber,
            Instant newAt,
            long newTookNanos,
            Occurrence newOccurrence,
            Configuration newBefore,
            Configuration newAfter,
            Outcome newOutcome,
            @Nullable Decision newDecision,
            String newDetail,
            String newLeft) {
        number = newNumber;
        at = newAt;
        tookNanos = newTookNanos;
        occurrence = newOccurrence;
        before = newBefore;
        after = newAfter;
        outcome = newOutcome;
        decision = newDecision;
        detail = newDetail;
        left = newLeft;
    }

    /** @param earlier how many events came before those that its history counts */
    HistoryEntry toEntry(long earlier) {
        Decision decided = decision;
        String details = detail(decided, detail);
        return new HistoryEntry(
                earlier + number,
                Objects.requireNonNull(at),
                Objects.requireNonNull(occurrence),
                Objects.requireNonNull(before),
                Objects.requireNonNull(after),
                Objects.requireNonNull(outcome),
                details.isEmpty() || left.isEmpty() ? details + left : details + "; " + left,
                decided,
                Duration.ofNanos(tookNanos));
    }

    /** What an entry says: {@code detail}, or else the words for the decision. */
    static String detail(@Nullable Decision decision, String detail) {
        return detail.isEmpty() && decision != null ? detail(decision) : detail;
    }

    private static String detail(Decision decision) {
        if (decision instanceof Decision.NotAcceptable) {
            return "not acceptable in " + decision.before().evolved();
        }
        if (decision instanceof Decision.Refused refused) {
            return refused.reason();
        }
        if (decision instanceof Decision.Impossible impossible) {
            return impossible.reason();
        }
        if (decision instanceof Decision.Resynchronization) {
            return decision.deviceBegan()
                    ? "the device has left for " + decision.after().original()
                    : "the device was found in " + decision.after().original();
        }
        boolean entersNew = decision instanceof Decision.NewState && decision.leavesState();
        List<String> steps = new ArrayList<>();
        for (Step step : decision.steps()) {
            if (!entersNew || !step.byDevice()) {
                steps.add(step.trigger() + (step.byDevice() ? " (by the device)" : ""));
            }
        }
        String sent = String.join(", ", steps);
        return entersNew
                ? (sent.isEmpty() ? "" : sent + "; ") + "new function of "
                        + decision.after().evolved()
                : sent;
    }
}
