package org.evoloop.check;

import java.util.ArrayList;
import java.util.Collection;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.stream.Collectors;
import org.evoloop.evolution.Configuration;
import org.evoloop.evolution.Decision;
import org.evoloop.evolution.DecisionTable;
import org.evoloop.evolution.Fallback;
import org.evoloop.evolution.OnFailure;
import org.evoloop.evolution.Passage;
import org.evoloop.evolution.Step;
import org.evoloop.evolution.Turn;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.State;
import org.evoloop.statemachine.Transition;

/** Notes on a pair that runs: events without effect, and what the device does on the way to a state. */
final class PairNotes {
    private static final int NAMED = 3;

    private final CheckInput input;
    private final DecisionTable table;
    private final PairGraph graph;
    private final List<Finding> findings = new ArrayList<>();

    PairNotes(CheckInput input, DecisionTable table, PairGraph graph) {
        this.input = input;
        this.table = table;
        this.graph = graph;
    }

    List<Finding> findings() {
        swallowed();
        passed();
        noFallbacks();
        return findings;
    }

    private record Swallowed(Configuration first, Set<Event> events, Set<State> where) {}

    private void swallowed() {
        Map<State, Swallowed> byState = new LinkedHashMap<>();
        for (Configuration at : graph.configurations()) {
            State state = at.evolved();
            if (input.pair().isNew(state) && canBeLeft(state)) {
                for (Transition transition : input.pair().original().transitionsFrom(at.original())) {
                    Event event = transition.event().trigger();
                    if (input.device().sendable().contains(event) && isSwallowed(state, event)) {
                        Swallowed here = byState.computeIfAbsent(
                                input.pair().evolved().withoutMemory(state),
                                key -> new Swallowed(at, new LinkedHashSet<>(), new LinkedHashSet<>()));
                        here.events().add(event);
                        here.where().add(at.original());
                    }
                }
            }
        }
        byState.forEach((state, swallowed) -> findings.add(new Finding(
                Rule.SWALLOWED_EVENT,
                new Element.OfState(Element.ModelRole.NEW, swallowed.first().evolved()),
                "new state " + state + " swallows " + names(swallowed.events()) + ", which the device knows in "
                        + names(swallowed.where()),
                "nothing, if such an event is to do nothing there; otherwise draw a transition for it")));
    }

    private boolean isSwallowed(State state, Event event) {
        return !input.pair().evolved().hasTrigger(state, event)
                && input.pair().evolved().deferred(state).stream()
                        .noneMatch(each -> each.trigger().equals(event));
    }

    /** If it cannot, that is either reported elsewhere or intended. */
    private boolean canBeLeft(State state) {
        return input.pair().evolved().transitionsFrom(state).stream()
                .anyMatch(transition -> !transition.target().equals(state));
    }

    private record Passed(Turn first, Set<Transition> transitions) {}

    private void passed() {
        Map<Passage, Passed> byState = new LinkedHashMap<>();
        for (Configuration at : graph.configurations()) {
            for (Turn turn : graph.turnsFrom(at)) {
                Transition transition = turn.decision().transition();
                if (transition != null && !(turn.decision() instanceof Decision.Impossible)) {
                    for (Passage passage :
                            Passage.of(turn.decision(), input.pair().original())) {
                        if (!passage.effects().isEmpty()) {
                            byState.computeIfAbsent(passage, key -> new Passed(turn, new LinkedHashSet<>()))
                                    .transitions()
                                    .add(transition);
                        }
                    }
                }
            }
        }
        byState.forEach((passage, passed) -> findings.add(new Finding(
                Rule.PASSED_EFFECT,
                new Element.OfState(Element.ModelRole.ORIGINAL, passage.state()),
                "on the way through " + passage.state() + " the device does " + String.join("; ", passage.effects())
                        + ": " + names(passed.transitions()),
                "nothing, if that may happen; otherwise give an event on the path a cost, or forbid paths through "
                        + "that state",
                graph.wayOver(passed.first()))));
    }

    private record Left(Transition transition, Step failed, OnFailure then) {}

    private void noFallbacks() {
        Map<Left, Turn> without = new LinkedHashMap<>();
        for (Configuration at : graph.configurations()) {
            for (Turn turn : graph.turnsFrom(at)) {
                Transition transition = turn.decision().transition();
                for (Fallback fallback : Fallback.of(table, turn.decision())) {
                    if (transition != null && fallback.way() == null) {
                        without.putIfAbsent(new Left(transition, fallback.failed(), fallback.then()), turn);
                    }
                }
            }
        }
        without.forEach((left, turn) -> findings.add(new Finding(
                Rule.NO_FALLBACK,
                new Element.OfTransition(Element.ModelRole.NEW, left.transition()),
                "if " + left.failed().trigger() + " fails in " + left.failed().source() + " on the way for "
                        + left.transition() + ", no events that can be sent lead "
                        + (left.then() == OnFailure.GO_BACK
                                ? "back to " + turn.decision().deviceStart()
                                : "on to " + turn.decision().after().original()),
                "let the device stay there, or draw a way that can be sent",
                graph.wayOver(turn))));
    }

    /** The first of them. */
    static String names(Collection<?> parts) {
        String first = parts.stream().limit(NAMED).map(Object::toString).collect(Collectors.joining(", "));
        return parts.size() > NAMED ? first + " and " + (parts.size() - NAMED) + " more" : first;
    }
}
