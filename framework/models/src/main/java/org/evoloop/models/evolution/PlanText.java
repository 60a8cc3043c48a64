package org.evoloop.models.evolution;

import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.stream.Collectors;
import org.evoloop.evolution.Configuration;
import org.evoloop.evolution.Fallback;
import org.evoloop.evolution.ModelPair;
import org.evoloop.evolution.OnFailure;
import org.evoloop.evolution.Step;
import org.evoloop.models.evolution.EvolutionPlan.Line;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.State;

/** A plan as text. */
public final class PlanText {
    private PlanText() {}

    public static String write(EvolutionPlan plan) {
        List<String> lines = new ArrayList<>();
        lines.add("plan from " + plan.pair().original() + " to " + plan.pair().evolved());
        lines.add("assumed: the converter can send " + names(plan.device().sendable()) + "; the device takes "
                + names(plan.device().spontaneous()) + " by itself");
        if (plan.pair().hasUrgent()) {
            lines.add("urgent: " + names(plan.pair().urgent()));
        }
        if (!plan.device().doNotPass().isEmpty()) {
            lines.add("not to be passed: "
                    + plan.device().doNotPass().stream()
                            .sorted()
                            .map(Object::toString)
                            .collect(Collectors.joining(", ")));
        }
        plan.device().costs().keySet().stream()
                .sorted()
                .forEach(event -> lines.add(
                        "cost of " + event + ": " + plan.device().costs().get(event)));
        lines.add("(device, system)");
        plan.lines().forEach(line -> {
            lines.add(line(line, plan.pair()));
            line.fallbacks().forEach(fallback -> lines.add("    " + fallback(fallback)));
        });
        plan.unreached().forEach(transition -> lines.add("never taken: " + DifferenceText.label(transition)));
        return String.join("\n", lines) + "\n";
    }

    private static String names(Set<Event> events) {
        String names = events.stream().sorted().map(Event::name).collect(Collectors.joining(", "));
        return names.isEmpty() ? "nothing" : names;
    }

    private static String line(Line line, ModelPair pair) {
        return line.at() + "  " + DifferenceText.label(line.transition()) + ":  " + what(line, pair);
    }

    private static String fallback(Fallback fallback) {
        List<Step> way = fallback.way();
        boolean back = fallback.then() == OnFailure.GO_BACK;
        String then = back ? "back" : "goes on";
        String sent = way == null || way.isEmpty()
                ? ""
                : " by " + way.stream().map(step -> step.trigger().name()).collect(Collectors.joining(", "));
        return "if " + fallback.failed().trigger() + " fails in "
                + fallback.failed().source() + ": "
                + (way == null ? (back ? "NO WAY BACK" : "NO OTHER WAY") + ", the device stays there" : then + sent);
    }

    /** How a transition is carried out, in words. */
    public static String what(Line line, ModelPair pair) {
        String sent = line.sent().stream().map(step -> step.trigger().name()).collect(Collectors.joining(", "));
        return switch (line.kind()) {
            case SAME_EVENT -> "same event " + sent;
            case PATH -> "path " + sent + way(line);
            case BY_DEVICE -> "the device has done it";
            case NOTHING ->
                "nothing to send, the device is in " + line.transition().target();
            case NEW_FUNCTION ->
                (sent.isEmpty() ? "" : "path " + sent + way(line) + ", ")
                        + (line.transition().internal() ? "stays in new function " : "new function ")
                        + pair.describe(reached(line));
            case IMPOSSIBLE -> "IMPOSSIBLE: " + line.reason();
        };
    }

    /** The states that the transition leads to. */
    private static Configuration reached(Line line) {
        List<Step> steps = line.steps();
        State device = steps.isEmpty()
                ? line.at().original()
                : steps.get(steps.size() - 1).target();
        return new Configuration(device, line.transition().target());
    }

    /** {@code Clean --Clean--> On --Spot--> Spot}. */
    private static String way(Line line) {
        StringBuilder way = new StringBuilder(line.sent().get(0).source().name());
        line.sent()
                .forEach(step ->
                        way.append(" --").append(step.event()).append("--> ").append(step.target()));
        return " (" + way + ")" + (line.isMarked() ? "  ! ON THE WAY: " + effects(line) : "");
    }

    private static String effects(Line line) {
        return line.passed().stream()
                .filter(passed -> !passed.effects().isEmpty())
                .map(passed -> "in " + passed.state() + " the device does " + String.join("; ", passed.effects()))
                .collect(Collectors.joining(", "));
    }
}
