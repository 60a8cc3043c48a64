package org.evoloop.page;

import java.time.Duration;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import org.evoloop.converter.Outlook;
import org.evoloop.engine.codec.DecisionKind;
import org.evoloop.evolution.Decision;
import org.evoloop.evolution.Step;
import org.evoloop.payload.JsonObject;
import org.evoloop.statemachine.Transition;
import org.jspecify.annotations.Nullable;

/**
 * What can happen next, for the page:
 *
 * <ul>
 *   <li>{@code events}: {@code event}, {@code source}, {@code deferred}, {@code delayMillis} of a timer, and {@code
 *   decisions}: {@code guards}, {@code kind}, {@code target} (null if the state is kept), {@code sends}, {@code reason}
 *   <li>{@code doubtful}: {@code source}, {@code event}, {@code target} of the step in doubt; null if there is none
 * </ul>
 */
final class OutlookJson {
    private OutlookJson() {}

    static JsonObject of(Outlook outlook) {
        return new JsonObject()
                .put("events", outlook.events().stream().map(OutlookJson::next).toList())
                .put("doubtful", doubtful(outlook.doubtful()));
    }

    private static JsonObject next(Outlook.Next next) {
        return new JsonObject()
                .put("event", next.trigger().name())
                .put("source", next.source().name().toLowerCase(Locale.ROOT))
                .put("deferred", next.deferred())
                .put("delayMillis", next.delay().map(Duration::toMillis).orElse(0L))
                .put(
                        "decisions",
                        next.decisions().stream().map(OutlookJson::decision).toList());
    }

    private static JsonObject decision(Decision decision) {
        Transition taken = decision.transition();
        return new JsonObject()
                .put("kind", DecisionKind.of(decision).word())
                .putTexts("guards", taken == null ? List.of() : taken.event().guards())
                .put(
                        "target",
                        taken == null || taken.internal()
                                ? null
                                : taken.target().name())
                .putTexts(
                        "sends",
                        decision.steps().stream()
                                .filter(step -> !step.byDevice())
                                .map(step -> step.trigger().name())
                                .toList())
                .put("reason", DecisionKind.reasonOf(decision));
    }

    private static @Nullable JsonObject doubtful(Optional<Step> step) {
        return step.map(known -> new JsonObject()
                        .put("source", known.source().name())
                        .put("event", known.event().toString())
                        .put("target", known.target().name()))
                .orElse(null);
    }
}
