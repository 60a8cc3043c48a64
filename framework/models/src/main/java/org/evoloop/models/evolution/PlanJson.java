package org.evoloop.models.evolution;

import com.fasterxml.jackson.annotation.JsonProperty;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import org.evoloop.evolution.Fallback;
import org.evoloop.evolution.OnFailure;
import org.evoloop.evolution.Step;
import org.evoloop.models.evolution.EvolutionPlan.Line;
import org.evoloop.models.format.Json;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.State;
import org.jspecify.annotations.Nullable;

/** A plan as JSON, in the shape that docs/models.md promises: components are the keys, in this order. */
public record PlanJson(
        String original,
        @JsonProperty("new") String evolved,
        List<String> sendable,
        List<String> spontaneous,
        List<String> urgent,
        List<String> doNotPass,
        Map<String, Integer> costs,
        List<Row> plan,
        List<TransitionJson> neverTaken) {

    /** One transition in one pair of states. {@code function} and {@code reason} are null where they do not apply. */
    public record Row(
            String originalState,
            String newState,
            TransitionJson transition,
            String kind,
            List<String> events,
            List<Through> through,
            boolean marked,
            List<OnFailed> onFailure,
            @Nullable String function,
            @Nullable String reason) {}

    /** An intermediate state and the device's effects in it. */
    public record Through(String state, List<String> effects) {}

    /** What follows when an event cannot be sent in a state; {@code events} is null if no path leads there. */
    public record OnFailed(
            String event,
            String originalState,
            String then,
            @Nullable List<String> events) {
        static OnFailed of(Fallback fallback) {
            List<Step> way = fallback.way();
            return new OnFailed(
                    fallback.failed().trigger().name(),
                    fallback.failed().source().name(),
                    fallback.then() == OnFailure.GO_BACK ? "back" : "otherWay",
                    way == null ? null : names(way));
        }
    }

    private static List<String> names(List<Step> steps) {
        return steps.stream().map(step -> step.trigger().name()).toList();
    }

    public static String write(EvolutionPlan plan) {
        Map<String, Integer> costs = new TreeMap<>();
        plan.device().costs().forEach((event, cost) -> costs.put(event.name(), cost));
        return Json.write(new PlanJson(
                plan.pair().original().name(),
                plan.pair().evolved().name(),
                plan.device().sendable().stream().map(Event::name).sorted().toList(),
                plan.device().spontaneous().stream().map(Event::name).sorted().toList(),
                plan.pair().urgent().stream().map(Event::name).sorted().toList(),
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
                names(line.sent()),
                line.passed().stream()
                        .map(passed -> new Through(passed.state().name(), passed.effects()))
                        .toList(),
                line.isMarked(),
                line.fallbacks().stream().map(OnFailed::of).toList(),
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
