package org.evoloop.models.evolution;

import org.evoloop.models.format.Json;
import org.evoloop.statemachine.Transition;
import org.jspecify.annotations.Nullable;

/** A transition as JSON, with the keys that {@code show} uses; null for missing parts. */
public record TransitionJson(
        String source,
        String trigger,
        @Nullable String guard,
        @Nullable String effect,
        String target) {

    static TransitionJson of(Transition transition) {
        return new TransitionJson(
                transition.source().name(),
                transition.event().name(),
                Json.orNull(String.join("] [", transition.event().guards())),
                Json.orNull(String.join("; ", transition.effects())),
                transition.target().name());
    }
}
