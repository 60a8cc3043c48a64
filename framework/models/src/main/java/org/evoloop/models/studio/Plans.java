package org.evoloop.models.studio;

import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import org.evoloop.evolution.DeviceEvents;
import org.evoloop.evolution.ModelPair;
import org.evoloop.evolution.Step;
import org.evoloop.models.checking.Drawing;
import org.evoloop.models.evolution.EvolutionPlan;
import org.evoloop.models.evolution.EvolutionPlan.Kind;
import org.evoloop.models.evolution.EvolutionPlan.Line;
import org.evoloop.models.evolution.PlanText;
import org.evoloop.payload.JsonObject;
import org.evoloop.statechart.Arc;
import org.evoloop.statemachine.Transition;
import org.evoloop.studio.Pair;

/** What the converter does for one drawn transition of the new model, in each pair of states in which it may come. */
final class Plans {
    private final Shown original;
    private final Shown evolved;
    private final ModelPair models;
    private final Drawing device;
    private final Drawing system;

    private Plans(Pair pair) {
        original = Shown.of(pair.original());
        evolved = Shown.of(pair.evolved());
        models = new ModelPair(original.require(), evolved.require());
        models.requireValid();
        device = original.drawing();
        system = evolved.drawing();
    }

    static JsonObject plan(Pair pair, String state, String event, String guard) {
        return new Plans(pair).of(state, event, guard);
    }

    private JsonObject of(String state, String event, String guard) {
        EvolutionPlan plan = EvolutionPlan.of(models, DeviceEvents.assumedOf(models.original()));
        List<Line> lines = plan.lines().stream()
                .filter(line -> isMeant(line.transition(), state, event, guard))
                .toList();
        if (lines.isEmpty()) {
            return new JsonObject()
                    .put("words", "never taken: no sequence of events leads there")
                    .put("steps", List.<JsonObject>of())
                    .put("lines", List.<JsonObject>of());
        }
        Set<String> words = lines.stream()
                .map(line -> PlanText.what(line, models))
                .collect(Collectors.toCollection(LinkedHashSet::new));
        JsonObject answer = new JsonObject()
                .put("words", String.join("; or ", words))
                .put("steps", steps(lines.get(0)))
                .put("lines", lines.stream().map(this::line).toList());
        if (lines.get(0).kind() == Kind.NEW_FUNCTION) {
            answer.put("function", lines.get(0).transition().target().name());
        }
        return answer;
    }

    private boolean isMeant(Transition transition, String state, String event, String guard) {
        Optional<Arc> drawn = system.transition(transition);
        return drawn.isPresent()
                && evolved.index().name(drawn.get().source()).equals(state)
                && (drawn.get().triggers().contains(event)
                        || String.join(", ", drawn.get().triggers()).equals(event))
                && (guard.isEmpty() || drawn.get().guard().equals(guard));
    }

    private JsonObject line(Line line) {
        return new JsonObject()
                .put("original", line.at().original().name())
                .put("new", line.at().evolved().name())
                .put("words", PlanText.what(line, models))
                .put("impossible", line.kind() == Kind.IMPOSSIBLE)
                .put("steps", steps(line));
    }

    private List<JsonObject> steps(Line line) {
        List<JsonObject> steps = new ArrayList<>();
        for (Step step : line.steps()) {
            steps.add(new JsonObject()
                    .put("source", step.source().name())
                    .put("event", step.trigger().name())
                    .put("target", step.target().name())
                    .put("byDevice", step.byDevice())
                    .put(
                            "id",
                            device.transition(step.transition())
                                    .map(original::id)
                                    .orElse("")));
        }
        return steps;
    }
}
