package org.evoloop.check;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Objects;
import java.util.Queue;
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

/** The rules about decisions, in every reachable pair of states. */
final class PairRules {
    private final CheckInput input;
    private final DecisionTable table;
    private final Set<State> originalReachable;
    private final Set<State> evolvedReachable;
    private final Set<Event> unsendable;
    private final GuardedTriggers guards;
    private final PairGraph graph;
    private final List<Finding> findings = new ArrayList<>();

    /** Transitions of the original model that are steps of a decision. */
    private final Set<Transition> had = new HashSet<>();

    /** Transitions of the new model whose event can come in some pair. */
    private final Set<Transition> live = new HashSet<>();

    /** Transitions of the new model to a state of the device that no path leads to. */
    private final Set<Transition> lacking = new HashSet<>();

    /** The states of the new model that it never reaches together with the device. */
    private final UnreachableStates missed;

    private final NoPathCauses noPath;
    private final NoPathCauses hazards;

    /** States of the device that some decision needs but that no events that can be sent lead to. */
    private final Set<State> unreached = new HashSet<>();

    PairRules(
            CheckInput input,
            DecisionTable table,
            PairGraph graph,
            MachineRules originalRules,
            MachineRules evolvedRules) {
        this.input = input;
        this.table = table;
        this.originalReachable = originalRules.reachable();
        this.unsendable = input.device().unsendable(input.pair().original());
        this.guards = new GuardedTriggers(input.pair().original());
        this.evolvedReachable = evolvedRules.reachable();
        this.graph = graph;
        this.missed = new UnreachableStates(input.pair().evolved(), met());
        this.noPath = new NoPathCauses(input.pair().original(), input.device());
        this.hazards = new NoPathCauses(input.pair().original(), input.device());
    }

    /** The states of the new model that events lead to that can come. */
    private Set<State> met() {
        Set<Configuration> seen = new HashSet<>();
        Set<State> met = new HashSet<>();
        Queue<Configuration> frontier = new ArrayDeque<>(List.of(input.pair().initial()));
        for (Configuration at = frontier.poll(); at != null; at = frontier.poll()) {
            if (seen.add(at)) {
                met.add(at.evolved());
                for (Turn turn : graph.turnsFrom(at)) {
                    boolean fails = turn.decision() instanceof Decision.Impossible;
                    if (!fails && canCome(at, turn.event().trigger())) {
                        frontier.add(turn.decision().after());
                    }
                }
            }
        }
        return met;
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
                        State target = transition(impossible).target();
                        impossible(turn, input.pair().whereDeviceMustBe(target), problems.contains(impossible));
                    }
                } else if (!turn.deviceActed()) {
                    turn.decision().steps().stream().map(Step::transition).forEach(had::add);
                }
            }
        }
        noPath.groups().forEach(this::noPath);
        hazards.groups().stream()
                .filter(group -> !unreached.containsAll(group.targets()))
                .forEach(this::hazard);
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
                    && !live.contains(transition)
                    && !lacking.contains(transition)) {
                findings.add(new Finding(
                        Rule.DEAD_TRANSITION,
                        new Element.OfTransition(Element.ModelRole.NEW, transition),
                        transition + " of the new model is never taken, since the device is never where it raises "
                                + transition.event().trigger() + " by itself" + missed(List.of(transition)),
                        "give it an event that comes there, or remove it"));
            }
        }
    }

    private static Transition transition(Decision.Impossible decision) {
        return Objects.requireNonNull(decision.transition());
    }

    /** @param targets the device's states of which one is wanted */
    private void impossible(Turn turn, List<State> targets, boolean problem) {
        if (problem) {
            noPath.add(turn, targets);
            unreached.addAll(targets);
            lacking.add(transition((Decision.Impossible) turn.decision()));
        } else if (canCome(turn.decision().before(), turn.event().trigger())) {
            hazards.add(turn, targets);
        }
    }

    /** Names the states of the new model that are lost, since none of these transitions can be taken. */
    private String missed(List<Transition> transitions) {
        List<String> names =
                missed.behind(transitions).stream().map(State::name).toList();
        return names.isEmpty() ? "" : "; so the new model never reaches " + String.join(", ", names);
    }

    private void noPath(NoPathCauses.Group group) {
        impossible(Rule.NO_PATH, group.turns(), remedy(group));
    }

    /** What the device does by itself cannot be sent, but a new state can wait for it where the device does it. */
    private String remedy(NoPathCauses.Group group) {
        Transition missing = group.missing().stream().findFirst().orElse(null);
        if (missing == null) {
            return "let the converter send an event that takes the device there, or draw another target";
        }
        Event trigger = missing.event().trigger();
        if (!isDevicesOwn(trigger)) {
            return "let the converter send " + PairNotes.names(group.unsendable()) + ", or draw another target";
        }
        Turn first = group.turns().get(0);
        State waiting = first.decision().before().evolved();
        boolean waits = input.pair().isNew(waiting)
                && input.pair().whereDeviceMustBe(waiting).isEmpty()
                && first.event().trigger().equals(trigger);
        return waits
                ? "give " + waiting + " the device state " + missing.source()
                : "draw a new state with device state " + missing.source() + " and a transition on " + trigger;
    }

    private void hazard(NoPathCauses.Group group) {
        impossible(Rule.HAZARD, group.turns(), "nothing, if the event may fail then; the state is entered again");
    }

    /** @param turns the turns with one cause */
    private void impossible(Rule rule, List<Turn> turns, String remedy) {
        Turn first = turns.get(0);
        Decision.Impossible decision = (Decision.Impossible) first.decision();
        String others = turns.size() == 1
                ? ""
                : "; the same holds for "
                        + PairNotes.names(turns.stream()
                                .skip(1)
                                .map(turn -> turn + " in " + turn.decision().before())
                                .toList());
        findings.add(new Finding(
                rule,
                new Element.OfTransition(Element.ModelRole.NEW, transition(decision)),
                "in " + decision.before()
                        + (first.deviceActed() ? ", when the device has acted on it by itself, " : " ")
                        + decision.reason() + others
                        + missed(turns.stream()
                                .map(turn -> transition((Decision.Impossible) turn.decision()))
                                .toList()),
                remedy,
                graph.wayOver(first)));
    }

    private void lost() {
        Set<State> visited = new HashSet<>();
        graph.configurations().forEach(at -> visited.add(at.original()));
        for (Transition transition : input.pair().original().transitions()) {
            if (originalReachable.contains(transition.source())
                    && !had.contains(transition)
                    && !unsendable.contains(transition.event().trigger())
                    && guards.shadowOf(transition) == null
                    && visited.contains(transition.source())
                    && !isReportedOtherwise(transition)) {
                findings.add(new Finding(
                        Rule.DEGRADATION,
                        new Element.OfTransition(Element.ModelRole.ORIGINAL, transition),
                        "what the device does on " + transition + " cannot be reached any more",
                        "nothing, if the new model does not need it; otherwise draw a transition that leads there"));
            }
        }
    }

    /**
     * A state of the device that the new model never enters is reported as an unreachable state, or as having no path.
     */
    private boolean isReportedOtherwise(Transition transition) {
        return !isEntered(transition.source())
                || !isEntered(transition.target())
                || unreached.contains(transition.target());
    }

    private boolean isEntered(State original) {
        return input.pair().evolvedStates(original).stream().anyMatch(evolvedReachable::contains);
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
                        new Element.OfTransition(Element.ModelRole.NEW, named),
                        "effect " + text + " of " + named + " is not bound",
                        "call effect(\"" + text + "\", ...) in registerNewFunctions"));
            }
        }
    }
}
