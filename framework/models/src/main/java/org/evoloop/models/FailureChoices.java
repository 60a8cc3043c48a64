package org.evoloop.models;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.evoloop.evolution.OnFailure;
import org.evoloop.statemachine.Names;
import org.evoloop.statemachine.State;
import org.evoloop.statemachine.StateMachine;
import org.evoloop.statemachine.Transition;

/** The values of {@code --on-failure}. */
final class FailureChoices {
    private static final Map<String, OnFailure> CHOICES =
            Map.of("stay", OnFailure.STAY, "back", OnFailure.GO_BACK, "other-way", OnFailure.OTHER_WAY);

    private FailureChoices() {}

    /**
     * The choices by state and event.
     *
     * @param given {@code EVENT} or {@code EVENT@STATE}, and the choice
     * @throws IllegalArgumentException for an unknown choice, or if {@code evolved} has no such transition
     */
    static Map<State, Map<String, OnFailure>> of(Map<String, String> given, StateMachine evolved) {
        Map<State, Map<String, OnFailure>> all = new HashMap<>();
        given.forEach((place, choice) -> {
            OnFailure then = CHOICES.get(choice);
            if (then == null) {
                throw new IllegalArgumentException("--on-failure " + place + "=" + choice
                        + ": choose from back, other-way, stay" + Names.hint(choice, CHOICES.keySet()));
            }
            List<Transition> meant = evolved.transitions().stream()
                    .filter(transition -> isMeant(place, transition, evolved))
                    .toList();
            if (meant.isEmpty()) {
                throw new IllegalArgumentException("--on-failure: the new model has no transition for " + place
                        + "; name an event, or EVENT@STATE");
            }
            meant.forEach(transition -> all.computeIfAbsent(transition.source(), state -> new HashMap<>())
                    .put(transition.event().toString(), then));
        });
        return all;
    }

    private static boolean isMeant(String place, Transition transition, StateMachine evolved) {
        State source = transition.source();
        return List.of(
                        transition.event().toString(),
                        transition.event().trigger().name())
                .stream()
                .anyMatch(event -> place.equals(event)
                        || place.equals(event + "@" + source)
                        || place.equals(event + "@" + evolved.withoutMemory(source)));
    }
}
