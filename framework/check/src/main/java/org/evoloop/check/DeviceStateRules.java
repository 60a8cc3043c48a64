package org.evoloop.check;

import java.time.Duration;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Set;
import org.evoloop.evolution.Configuration;
import org.evoloop.evolution.Decision;
import org.evoloop.evolution.ModelPair;
import org.evoloop.evolution.Turn;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.Names;
import org.evoloop.statemachine.State;
import org.evoloop.statemachine.Transition;
import org.jspecify.annotations.Nullable;

/** The rules about new states that use the device: where it must be there, and what their functions send. */
final class DeviceStateRules {
    private final CheckInput input;
    private final ModelPair pair;
    private final PairGraph graph;
    private final List<Finding> findings = new ArrayList<>();

    DeviceStateRules(CheckInput input, PairGraph graph) {
        this.input = input;
        this.pair = input.pair();
        this.graph = graph;
    }

    List<Finding> findings() {
        Map<State, Set<State>> where = new HashMap<>();
        graph.configurations()
                .forEach(at -> where.computeIfAbsent(at.evolved(), state -> new LinkedHashSet<>())
                        .add(at.original()));
        Set<String> seen = new HashSet<>();
        for (State state : pair.evolved().states()) {
            Set<State> places = where.getOrDefault(state, Set.of());
            if (pair.isNew(state) && !places.isEmpty()) {
                List<Finding> here = new ArrayList<>();
                sends(state, places, here);
                leaves(state, here);
                // Those of the variants of a history are the same.
                here.stream()
                        .filter(finding -> seen.add(finding.rule() + finding.message()))
                        .forEach(findings::add);
            }
        }
        restless();
        return findings;
    }

    private void sends(State state, Set<State> places, List<Finding> here) {
        List<State> needed = pair.whereDeviceMustBe(state);
        for (Event event : pair.evolved().sends(state)) {
            List<Transition> known = places.stream()
                    .flatMap(place -> pair.original().transitionsFrom(place).stream())
                    .filter(transition -> transition.event().trigger().equals(event))
                    .toList();
            if (!input.device().sendable().contains(event)) {
                boolean exists = pair.original().triggers().contains(event);
                String meant =
                        exists ? "" : Names.meant(event.name(), input.device().sendable());
                String remedy = meant.isEmpty() ? "remove it, or let the converter send it" : meant.substring(2);
                sends(state, "which cannot be sent", remedy, event, here);
            } else if (known.isEmpty()) {
                sends(
                        state,
                        "which the device does not know there: it is in " + PairNotes.names(places),
                        "remove it, or give the state a device state in which the device knows it",
                        event,
                        here);
            }
            known.stream()
                    .filter(transition -> !needed.isEmpty() && !needed.contains(transition.target()))
                    .findFirst()
                    .ifPresent(transition -> sends(
                            state,
                            "which takes the device out of its device state to " + transition.target(),
                            "draw another new state with the device state " + transition.target(),
                            event,
                            here));
        }
    }

    private void sends(State state, String why, String remedy, Event event, List<Finding> here) {
        here.add(new Finding(
                Rule.DECLARED_SEND,
                new Element.OfState(Element.ModelRole.NEW, state),
                "the function of " + plain(state) + " sends " + event + ", " + why,
                remedy));
    }

    /** What becomes of a state when the device leaves its device state by itself. */
    private void leaves(State state, List<Finding> here) {
        List<State> needed = pair.evolved().deviceState(state) == null ? List.of() : pair.whereDeviceMustBe(state);
        for (State place : needed) {
            for (Transition own : pair.original().transitionsFrom(place)) {
                Event event = own.event().trigger();
                boolean byItself = input.device().declaredBy(pair.original()).isOwn(event);
                if (byItself && !pair.evolved().hasTrigger(state, event) && !needed.contains(own.target())) {
                    here.add(new Finding(
                            Rule.DEVICE_LEAVES,
                            new Element.OfState(Element.ModelRole.NEW, state),
                            "in " + plain(state) + " the device can leave " + place + " by " + event
                                    + ", for which the new model draws nothing there; it follows the device to "
                                    + own.target(),
                            "nothing, if it may follow; otherwise draw a transition for " + event));
                }
                if (byItself) {
                    timers(state, own, here);
                }
            }
        }
    }

    private void timers(State state, Transition own, List<Finding> here) {
        State led = target(state, own);
        for (Transition timed : pair.evolved().transitionsFrom(state)) {
            Event timer = timed.event().trigger();
            if (timer.timeTrigger().isPresent()
                    && !timer.equals(own.event().trigger())
                    && !plain(timed.target()).equals(plain(led))) {
                here.add(new Finding(
                        Rule.TIMER_OR_DEVICE,
                        new Element.OfTransition(Element.ModelRole.NEW, timed),
                        "in " + plain(state) + ", " + timer + " leads to " + plain(timed.target()) + ", but "
                                + own.event().trigger() + ", which the device raises in " + own.source()
                                + " by itself, leads to " + plain(led) + "; whichever comes first decides",
                        "nothing, if " + own.event().trigger() + " takes longer than that, or both are right"));
            }
        }
    }

    /** Where the new model goes when the device takes a transition by itself: as drawn, else where the device goes. */
    private State target(State state, Transition own) {
        return pair.evolved().transitionsFrom(state).stream()
                .filter(transition ->
                        transition.event().trigger().equals(own.event().trigger()))
                .map(Transition::target)
                .findFirst()
                .orElseGet(() -> pair.evolvedStates(own.target()).get(0));
    }

    private State plain(State state) {
        return pair.evolved().withoutMemory(state);
    }

    /** Circles of timers that are due at once, on which something is sent. */
    private void restless() {
        Set<Configuration> done = new HashSet<>();
        for (Configuration start : graph.configurations()) {
            List<Turn> circle = done.contains(start) ? null : circle(start, done);
            if (circle != null) {
                Turn first = circle.get(0);
                List<String> sent = circle.stream()
                        .flatMap(turn -> turn.decision().steps().stream())
                        .map(step -> step.trigger().name())
                        .toList();
                findings.add(new Finding(
                        Rule.RESTLESS,
                        new Element.OfTransition(
                                Element.ModelRole.NEW,
                                Objects.requireNonNull(first.decision().transition())),
                        "from " + first.decision().before() + " timers of no length lead back there, and "
                                + PairNotes.names(sent) + " is sent again and again, without an end",
                        "give one of these timers a length",
                        graph.wayOver(circle.get(circle.size() - 1))));
            }
        }
    }

    /** The circle that the first such turn of each configuration leads into, if it sends something; else null. */
    private @Nullable List<Turn> circle(Configuration start, Set<Configuration> done) {
        List<Turn> way = new ArrayList<>();
        Map<Configuration, Integer> places = new HashMap<>();
        Configuration at = start;
        while (done.add(at)) {
            places.put(at, way.size());
            Turn next = graph.turnsFrom(at).stream()
                    .filter(DeviceStateRules::isAtOnce)
                    .findFirst()
                    .orElse(null);
            if (next == null) {
                return null;
            }
            way.add(next);
            at = next.decision().after();
            Integer begin = places.get(at);
            if (begin != null) {
                List<Turn> circle = way.subList(begin, way.size());
                boolean sends = circle.stream()
                        .flatMap(turn -> turn.decision().steps().stream())
                        .anyMatch(step -> !step.byDevice());
                return sends ? circle : null;
            }
        }
        return null;
    }

    private static boolean isAtOnce(Turn turn) {
        return turn.decision().transition() != null
                && !(turn.decision() instanceof Decision.Impossible)
                && turn.event().timeTrigger().filter(Duration.ZERO::equals).isPresent();
    }
}
