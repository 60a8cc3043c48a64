package org.evoloop.models.evolution;

import com.fasterxml.jackson.annotation.JsonProperty;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import org.evoloop.models.evolution.EvolutionPlan.Line;
import org.evoloop.models.format.Json;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.State;
import org.jspecify.annotations.Nullable;

/** A plan for programs, in the shape that docs/models.md promises: components are the keys, in this order. */
public record PlanJson(
        String original,
        @JsonProperty("new") String evolved,
        List<String> sendable,
        List<String> spontaneous,
        List<String> doNotPass,
        Map<String, Integer> costs,
        List<Row> plan,
        List<TransitionJson> neverTaken) {

    /** One transition in one pair of states; {@code function} and {@code reason} are null where there is none. */
    public record Row(
            String originalState,
            String newState,
            TransitionJson transition,
            String kind,
            List<String> events,
            List<Through> through,
            boolean marked,
            @Nullable String function,
            @Nullable String reason) {}

    /** A state that is passed, and what the device does there. */
    public record Through(String state, List<String> effects) {}

    public static String write(EvolutionPlan plan) {
        Map<String, Integer> costs = new TreeMap<>();
        plan.device().costs().forEach((event, cost) -> costs.put(event.name(), cost));
        return Json.write(new PlanJson(
                plan.pair().original().name(),
                plan.pair().evolved().name(),
                plan.device().sendable().stream().map(Event::name).sorted().toList(),
                plan.device().spontaneous().stream().map(Event::name).sorted().toList(),
                plan.device().doNotPass().stream().map(State::name).sorted().toList(),
                costs,
                plan.lines().stream().map(PlanJson::row).toList(),
                plan.unreached().stream().map(TransitionJson::of).toList()));
    }

    private static Row row(Line line) {
        return new Row(
                line.at().original().name(),
                line.at().evolved().name(),
                TransitionJson.of(line.transition()),
                kind(line.kind()),
                line.sent().stream().map(step -> step.trigger().name()).toList(),
                line.passed().stream()
                        .map(passed -> new Through(passed.state().name(), passed.effects()))
                        .toList(),
                line.isMarked(),
                line.kind() == EvolutionPlan.Kind.NEW_FUNCTION
                        ? line.transition().target().name()
                        : null,
                Json.orNull(line.reason()));
    }

    private static String kind(EvolutionPlan.Kind kind) {
        return switch (kind) {
            case SAME_EVENT -> "sameEvent";
            case PATH -> "path";
            case BY_DEVICE -> "byDevice";
            case NOTHING -> "nothing";
            case NEW_FUNCTION -> "newFunction";
            case IMPOSSIBLE -> "impossible";
        };
    }
}
