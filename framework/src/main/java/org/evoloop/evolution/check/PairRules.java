package org.evoloop.evolution.check;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Objects;
import java.util.Set;
import org.evoloop.evolution.Configuration;
import org.evoloop.evolution.Decision;
import org.evoloop.evolution.DecisionTable;
import org.evoloop.evolution.GuardedTriggers;
import org.evoloop.evolution.Step;
import org.evoloop.evolution.Turn;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.State;
import org.evoloop.statemachine.Transition;

/** The rules about decisions, in every pair of states that can be reached. */
final class PairRules {
    private final CheckInput input;
    private final DecisionTable table;
    private final Set<State> originalReachable;
    private final Set<Event> unsendable;
    private final GuardedTriggers guards;
    private final PairGraph graph;
    private final List<Finding> findings = new ArrayList<>();

    /** Transitions of the original model that are steps of a decision. */
    private final Set<Transition> had = new HashSet<>();

    /** Transitions of the new model whose event can come in some pair. */
    private final Set<Transition> live = new HashSet<>();

    PairRules(CheckInput input, DecisionTable table, MachineRules originalRules) {
        this.input = input;
        this.table = table;
        this.originalReachable = originalRules.reachable();
        this.unsendable = input.device().unsendable(input.pair().original());
        this.guards = new GuardedTriggers(input.pair().original());
        this.graph = new PairGraph(input.pair().initial(), table);
    }

    List<Finding> findings() {
        Set<Decision.Impossible> problems = new HashSet<>(table.problems());
        for (Configuration at : graph.configurations()) {
            for (Turn turn : graph.turnsFrom(at)) {
                Transition taken = turn.decision().transition();
                if (taken != null && canCome(at, taken.event().trigger())) {
                    live.add(taken);
                }
                if (turn.decision() instanceof Decision.Impossible impossible) {
                    if (!unsendable.contains(turn.event().trigger())) {
                        impossible(turn, impossible, problems.contains(impossible));
                    }
                } else if (!turn.deviceActed()) {
                    turn.decision().steps().stream().map(Step::transition).forEach(had::add);
                }
            }
        }
        dead();
        lost();
        unboundEffects();
        return findings;
    }

    /** An event that only the device can raise comes only where its own model has it. */
    private boolean canCome(Configuration at, Event trigger) {
        return !isDevicesOwn(trigger) || input.pair().original().hasTrigger(at.original(), trigger);
    }

    private boolean isDevicesOwn(Event trigger) {
        return table.device().isOwn(trigger);
    }

    private void dead() {
        Set<State> visited = new HashSet<>();
        graph.configurations().forEach(at -> visited.add(at.evolved()));
        for (Transition transition : input.pair().evolved().transitions()) {
            if (isDevicesOwn(transition.event().trigger())
                    && visited.contains(transition.source())
                    && !live.contains(transition)) {
                findings.add(new Finding(
                        Rule.DEAD_TRANSITION,
                        new Element.OfTransition(Element.Side.NEW, transition),
                        transition + " of the new model is never taken, since the device is never where it raises "
                                + transition.event().trigger() + " by itself",
                        "give it an event that comes there, or remove it"));
            }
        }
    }

    private void impossible(Turn turn, Decision.Impossible decision, boolean problem) {
        findings.add(new Finding(
                problem ? Rule.NO_PATH : Rule.HAZARD,
                new Element.OfTransition(Element.Side.NEW, Objects.requireNonNull(decision.transition())),
                "in " + decision.before() + (turn.deviceActed() ? ", when the device has acted on it by itself, " : " ")
                        + decision.reason(),
                problem
                        ? "let the converter send an event that takes the device there, or draw another target"
                        : "nothing, if the event may fail then; the state is entered anew",
                graph.wayOver(turn)));
    }

    private void lost() {
        for (Transition transition : input.pair().original().transitions()) {
            if (originalReachable.contains(transition.source())
                    && !had.contains(transition)
                    && !unsendable.contains(transition.event().trigger())
                    && guards.shadowOf(transition) == null) {
                findings.add(new Finding(
                        Rule.DEGRADATION,
                        new Element.OfTransition(Element.Side.ORIGINAL, transition),
                        "what the device does on " + transition + " can no longer be had",
                        "nothing, if the new model is to do without; else draw a transition that leads there"));
            }
        }
    }

    private void unboundEffects() {
        Set<String> bound = input.effects();
        if (bound == null) {
            return;
        }
        for (String text : table.effects()) {
            if (!bound.contains(text)) {
                Transition named = input.pair().evolved().transitions().stream()
                        .filter(transition -> transition.effects().contains(text))
                        .findFirst()
                        .orElseThrow();
                findings.add(new Finding(
                        Rule.UNBOUND_EFFECT,
                        new Element.OfTransition(Element.Side.NEW, named),
                        "effect " + text + " of " + named + " is not bound",
                        "call effect(\"" + text + "\", ...) in registerNewFunctions"));
            }
        }
    }
}
