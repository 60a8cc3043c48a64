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
 * What the converter will do: one line for each transition of the new model in each reachable pair of states.
 *
 * <p>Threading: immutable.
 *
 * @param unreached transitions of the new model that are never taken in a reachable pair of states
 */
public record EvolutionPlan(ModelPair pair, DeviceEvents device, List<Line> lines, List<Transition> unreached) {
    public EvolutionPlan {
        lines = List.copyOf(lines);
        unreached = List.copyOf(unreached);
    }

    /** How a transition is carried out. */
    public enum Kind {
        /** The event itself is sent to the device. */
        SAME_EVENT,
        /** One or more events of the device's own model are sent to it. */
        PATH,
        /** The device has already taken the step by itself. */
        BY_DEVICE,
        /** The device is already in the right state. */
        NOTHING,
        /** A new function starts or continues, after a path to the device state if the new state has one. */
        NEW_FUNCTION,
        /** It cannot be carried out. */
        IMPOSSIBLE
    }

    /**
     * One transition of the new model in one pair of states.
     *
     * @param steps of the device, including those that it takes itself
     * @param passed the device's intermediate states
     * @param fallbacks what follows when a step fails, where the author has specified it
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

        /** Whether the path passes a state in which the device does something by itself. */
        public boolean isMarked() {
            return passed.stream().anyMatch(state -> !state.effects().isEmpty());
        }

        /** The steps to be sent, in order. */
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
