package org.evoloop.engine.codec;

import java.util.List;
import java.util.Locale;
import org.evoloop.evolution.Configuration;
import org.evoloop.evolution.Decision;
import org.evoloop.evolution.Step;
import org.evoloop.statemachine.Transition;
import org.jspecify.annotations.Nullable;

/**
 * The kinds of decisions: their names in texts, and how a decision is rebuilt from its parts.
 *
 * @since 0.1
 */
public enum DecisionKind {
    /** {@link Decision.NotAcceptable}. */
    NOT_ACCEPTABLE,
    /** {@link Decision.ExistingState}. */
    EXISTING_FUNCTION,
    /** {@link Decision.NewState}. */
    NEW_FUNCTION,
    /** {@link Decision.Resynchronization}. */
    RESYNCHRONIZATION,
    /** {@link Decision.Sending}. */
    SENDING,
    /** {@link Decision.Inquiry}. */
    INQUIRY,
    /** {@link Decision.Refused}. */
    REFUSED,
    /** {@link Decision.Impossible}. */
    IMPOSSIBLE;

    private final String word;

    DecisionKind() {
        word = name().toLowerCase(Locale.ROOT).replace('_', '-');
    }

    /** Its name in texts: {@code existing-function}. */
    public String word() {
        return word;
    }

    /** The kind of {@code decision}. */
    public static DecisionKind of(Decision decision) {
        if (decision instanceof Decision.NotAcceptable) {
            return NOT_ACCEPTABLE;
        } else if (decision instanceof Decision.ExistingState) {
            return EXISTING_FUNCTION;
        } else if (decision instanceof Decision.NewState) {
            return NEW_FUNCTION;
        } else if (decision instanceof Decision.Resynchronization) {
            return RESYNCHRONIZATION;
        } else if (decision instanceof Decision.Sending) {
            return SENDING;
        } else if (decision instanceof Decision.Inquiry) {
            return INQUIRY;
        }
        return decision instanceof Decision.Refused ? REFUSED : IMPOSSIBLE;
    }

    /** Why the decision has no effect; empty for kinds that have no reason. */
    public static String reasonOf(Decision decision) {
        if (decision instanceof Decision.Refused refused) {
            return refused.reason();
        }
        return decision instanceof Decision.Impossible impossible ? impossible.reason() : "";
    }

    /** Whether such a decision needs a transition of the new model. */
    public boolean needsTransition() {
        return this == EXISTING_FUNCTION || this == NEW_FUNCTION;
    }

    /**
     * A decision of this kind.
     *
     * @param transition not null if it {@linkplain #needsTransition() is needed}
     */
    public Decision made(
            Configuration before,
            Configuration after,
            List<Step> steps,
            @Nullable Transition transition,
            List<String> effects,
            String reason) {
        if (transition != null && this == EXISTING_FUNCTION) {
            return new Decision.ExistingState(before, after, steps, transition, effects);
        } else if (transition != null && this == NEW_FUNCTION) {
            return new Decision.NewState(before, after, steps, transition, effects);
        }
        return switch (this) {
            case NOT_ACCEPTABLE -> new Decision.NotAcceptable(before, after, steps);
            case RESYNCHRONIZATION -> new Decision.Resynchronization(before, after, steps);
            case SENDING -> new Decision.Sending(before, after, steps);
            case INQUIRY -> new Decision.Inquiry(before);
            case REFUSED -> new Decision.Refused(before, reason);
            case IMPOSSIBLE -> new Decision.Impossible(before, after, steps, transition, reason);
            default -> throw new IllegalArgumentException(this + " without a transition");
        };
    }
}
