package org.evoloop.page;

import java.util.Locale;
import org.evoloop.converter.HistoryEntry;
import org.evoloop.engine.codec.DecisionKind;
import org.evoloop.evolution.Configuration;
import org.evoloop.evolution.Decision;
import org.evoloop.evolution.Step;
import org.evoloop.payload.JsonObject;
import org.evoloop.statemachine.Transition;
import org.jspecify.annotations.Nullable;

/**
 * An event and the reason for its outcome, for the page:
 *
 * <ul>
 *   <li>{@code number}, {@code at}, {@code observedAt}, {@code event} (with guards), {@code source}, {@code deviceActed}, {@code values},
 *   {@code outcome}, {@code detail}, {@code tookNanos}
 *   <li>{@code before}, {@code after}: {@code original}, {@code new}
 *   <li>{@code decision}: its {@code kind}, such as {@code existing-function}; {@code transition} of the new model;
 *   {@code steps} of the original one; {@code effects} that the converter runs. {@code null} if nothing was decided
 * </ul>
 */
final class EntryJson {
    private EntryJson() {}

    static JsonObject of(HistoryEntry entry) {
        return new JsonObject()
                .put("number", entry.number())
                .put("at", entry.at().toString())
                .put("observedAt", entry.observedAt().toString())
                .put("event", entry.occurrence().label())
                .put("source", entry.occurrence().source().name().toLowerCase(Locale.ROOT))
                .put("deviceActed", entry.occurrence().isFact())
                .put(
                        "values",
                        entry.occurrence().values().isEmpty()
                                ? ""
                                : entry.occurrence().values().toString())
                .put("before", states(entry.before()))
                .put("after", states(entry.after()))
                .put("outcome", entry.outcome().name().toLowerCase(Locale.ROOT))
                .put("detail", entry.detail())
                .put("tookNanos", entry.took().toNanos())
                .put("decision", decision(entry.decision()));
    }

    private static JsonObject states(Configuration at) {
        return new JsonObject()
                .put("original", at.original().name())
                .put("new", at.evolved().name());
    }

    private static @Nullable JsonObject decision(@Nullable Decision decision) {
        if (decision == null) {
            return null;
        }
        Transition taken = decision.transition();
        return new JsonObject()
                .put("kind", DecisionKind.of(decision).word())
                .put("transition", taken == null ? null : transition(taken))
                .put("steps", decision.steps().stream().map(EntryJson::step).toList())
                .putTexts("effects", decision.effects());
    }

    private static JsonObject step(Step step) {
        return transition(step.transition())
                .put("sends", step.trigger().name())
                .put("byDevice", step.byDevice())
                .put("conditional", step.conditional());
    }

    private static JsonObject transition(Transition transition) {
        return new JsonObject()
                .put("source", transition.source().name())
                .put("event", transition.event().toString())
                .putTexts("guards", transition.event().guards())
                .putTexts("effects", transition.effects())
                .put("target", transition.target().name());
    }
}
