package org.evoloop.models.evolution;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import org.evoloop.evolution.Configuration;
import org.evoloop.evolution.Decision;
import org.evoloop.evolution.DecisionTable;
import org.evoloop.evolution.DeviceEvents;
import org.evoloop.evolution.Fallback;
import org.evoloop.evolution.GuardedTriggers;
import org.evoloop.evolution.ModelPair;
import org.evoloop.evolution.Passage;
import org.evoloop.evolution.Step;
import org.evoloop.statemachine.Transition;

/**
 * What the converter will do: a line for each transition of the new model in each pair of states that can be reached.
 *
 * <p>Threading: immutable.
 *
 * @param unreached transitions of the new model that are taken in no pair of states that can be reached
 */
public record EvolutionPlan(ModelPair pair, DeviceEvents device, List<Line> lines, List<Transition> unreached) {
    public EvolutionPlan {
        lines = List.copyOf(lines);
        unreached = List.copyOf(unreached);
    }

    /** How a transition comes about. */
    public enum Kind {
        /** The device gets the event itself. */
        SAME_EVENT,
        /** The device gets one or more events of its own model. */
        PATH,
        /** The device has taken the step by itself. */
        BY_DEVICE,
        /** The device stands where it should already. */
        NOTHING,
        /** A new function starts, or goes on. */
        NEW_FUNCTION,
        /** Nobody can carry it out. */
        IMPOSSIBLE
    }

    /**
     * One transition of the new model in one pair of states.
     *
     * @param steps of the device, those that it takes itself too
     * @param passed the states of the device on the way, without the last
     * @param fallbacks what follows when a step fails, where the author has said so
     * @param reason why it is impossible; else empty
     */
    public record Line(
            Configuration at,
            Transition transition,
            Kind kind,
            List<Step> steps,
            List<Passage> passed,
            List<Fallback> fallbacks,
            String reason) {
        public Line {
            fallbacks = List.copyOf(fallbacks);
            steps = List.copyOf(steps);
            passed = List.copyOf(passed);
        }

        /** Whether the way leads through a state that does something by itself. */
        public boolean isMarked() {
            return passed.stream().anyMatch(state -> !state.effects().isEmpty());
        }

        /** What is sent, in order. */
        public List<Step> sent() {
            return steps.stream().filter(step -> !step.byDevice()).toList();
        }
    }

    /**
     * The plan of {@code pair}.
     *
     * @param pair a valid one
     */
    public static EvolutionPlan of(ModelPair pair, DeviceEvents device) {
        DecisionTable table = DecisionTable.compile(pair, device);
        GuardedTriggers guards = new GuardedTriggers(pair.evolved());
        List<Line> lines = new ArrayList<>();
        Set<Transition> taken = new HashSet<>();
        for (Configuration at : table.configurations()) {
            for (Transition transition : pair.evolved().transitionsFrom(at.evolved())) {
                if (guards.shadowOf(transition) == null) {
                    taken.add(transition);
                    Decision decision = table.decide(at, transition.event(), false);
                    lines.add(line(at, transition, decision, table));
                }
            }
        }
        List<Transition> unreached = pair.evolved().transitions().stream()
                .filter(transition -> !taken.contains(transition))
                .toList();
        return new EvolutionPlan(pair, table.device(), lines, unreached);
    }

    private static Line line(Configuration at, Transition transition, Decision decision, DecisionTable table) {
        String reason = decision instanceof Decision.Impossible impossible ? impossible.reason() : "";
        return new Line(
                at,
                transition,
                kind(transition, decision),
                decision.steps(),
                Passage.of(decision, table.models().original()),
                Fallback.of(table, decision),
                reason);
    }

    private static Kind kind(Transition transition, Decision decision) {
        if (decision instanceof Decision.Impossible) {
            return Kind.IMPOSSIBLE;
        }
        if (!(decision instanceof Decision.ExistingState)) {
            return Kind.NEW_FUNCTION;
        }
        List<Step> sent =
                decision.steps().stream().filter(step -> !step.byDevice()).toList();
        if (sent.isEmpty()) {
            return decision.steps().isEmpty() ? Kind.NOTHING : Kind.BY_DEVICE;
        }
        boolean same = decision.steps().size() == 1
                && sent.get(0).trigger().equals(transition.event().trigger());
        return same ? Kind.SAME_EVENT : Kind.PATH;
    }
}
