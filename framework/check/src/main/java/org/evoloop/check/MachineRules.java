package org.evoloop.check;

import java.time.Duration;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Queue;
import java.util.Set;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import org.evoloop.evolution.GuardedTriggers;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.State;
import org.evoloop.statemachine.StateMachine;
import org.evoloop.statemachine.Transition;

/** The rules about a single machine. */
final class MachineRules {
    /** Names that look like a time trigger to people, but are ordinary events. */
    private static final Pattern LIKE_A_TIMER =
            Pattern.compile("(?i)(?:tm|after|at|when)[\\s(\\[{_]*[0-9]+(?:[.,][0-9]+)?\\s*(?:ms|s|sec|min|h)?[)\\]}]*");

    private final Element.ModelRole side;
    private final Set<State> reported;
    private final StateMachine machine;
    private final GuardedTriggers guards;
    private final Set<State> reachable = new LinkedHashSet<>();

    /** Time triggers of enclosing states: they may have run for a while when a state is entered. */
    private final Set<String> kept = new HashSet<>();

    private final Set<Event> likeTimers = new HashSet<>();
    private final List<Finding> findings = new ArrayList<>();

    /** @param reported unreachable states that are reported for another machine */
    MachineRules(Element.ModelRole side, StateMachine machine, Set<State> reported) {
        this.side = side;
        this.reported = reported;
        this.machine = machine;
        this.guards = new GuardedTriggers(machine);
        machine.transitions().forEach(transition -> kept.addAll(transition.keeps()));
        Queue<State> frontier = new ArrayDeque<>(List.of(machine.initial()));
        for (State at = frontier.poll(); at != null; at = frontier.poll()) {
            if (reachable.add(at)) {
                machine.transitionsFrom(at).stream()
                        .filter(transition -> guards.shadowOf(transition) == null)
                        .forEach(transition -> frontier.add(transition.target()));
            }
        }
    }

    /** The reachable states. */
    Set<State> reachable() {
        return reachable;
    }

    /** The states that no sequence of events leads to. */
    Set<State> unreachable() {
        Set<State> unreachable = new HashSet<>(machine.states());
        unreachable.removeAll(reachable);
        return unreachable;
    }

    List<Finding> findings() {
        for (State state : reachableAsDrawn()) {
            List<Transition> outgoing = machine.transitionsFrom(state);
            outgoing.forEach(this::shadowed);
            timers(outgoing);
            overlaps(outgoing);
        }
        traps();
        reportUnreachable();
        return findings;
    }

    private List<State> reachableAsDrawn() {
        return machine.states().stream().filter(reachable::contains).toList();
    }

    private void reportUnreachable() {
        Set<State> known = new HashSet<>(reachable);
        known.addAll(reported);
        new UnreachableStates(machine, known).roots().forEach((state, lost) -> {
            String others = lost.isEmpty()
                    ? ""
                    : ", nor to " + lost.stream().map(State::name).collect(Collectors.joining(", "))
                            + " that it leads to";
            findings.add(new Finding(
                    Rule.UNREACHABLE_STATE,
                    new Element.OfState(side, state),
                    "no sequence of events leads to state " + state + " of " + name() + others,
                    "draw a transition that leads there, or remove it"));
        });
    }

    private String name() {
        return side == Element.ModelRole.ORIGINAL ? "the original model" : "the new model";
    }

    private Element element(Transition transition) {
        return new Element.OfTransition(side, transition);
    }

    private void shadowed(Transition transition) {
        Transition shadow = guards.shadowOf(transition);
        if (shadow == null) {
            return;
        }
        boolean sameGuards = Set.copyOf(shadow.event().guards())
                .equals(Set.copyOf(transition.event().guards()));
        findings.add(
                sameGuards
                        ? new Finding(
                                Rule.NONDETERMINISM,
                                element(transition),
                                shadow + " and " + transition + " of " + name()
                                        + " leave one state on one event under the same guards",
                                "remove one of them or give it another event or guard")
                        : new Finding(
                                Rule.DEAD_TRANSITION,
                                element(transition),
                                transition + " of " + name() + " is never taken, since " + shadow
                                        + " comes first whenever it could be",
                                "draw it before the other, give the other a guard, or remove it"));
    }

    private void timers(List<Transition> outgoing) {
        Map<Duration, Transition> byDelay = new HashMap<>();
        Transition first = null;
        for (Transition transition : outgoing) {
            Duration delay = transition.event().timeTrigger().orElse(null);
            if (delay == null) {
                likeATimer(transition);
                continue;
            }
            if (transition.event().guards().isEmpty()
                    && !transition.internal()
                    && !kept.contains(transition.event().name())) {
                Transition same = byDelay.putIfAbsent(delay, transition);
                if (same != null) {
                    findings.add(new Finding(
                            Rule.NONDETERMINISM,
                            element(transition),
                            same + " and " + transition + " of " + name() + " come at the same time",
                            "remove one of them or let it wait longer"));
                }
                if (first == null || delay.compareTo(delayOf(first)) < 0) {
                    first = transition;
                }
            }
        }
        for (Transition transition : outgoing) {
            Duration delay = transition.event().timeTrigger().orElse(Duration.ZERO);
            if (first != null
                    && delay.compareTo(delayOf(first)) > 0
                    && !kept.contains(transition.event().name())) {
                findings.add(new Finding(
                        Rule.TIMER_CANNOT_FIRE,
                        element(transition),
                        transition.event() + " never comes in state " + transition.source() + " of " + name()
                                + ", which is left on " + first.event() + " before",
                        "let it wait for less, or give the other a guard"));
            }
        }
    }

    private static Duration delayOf(Transition transition) {
        return transition.event().timeTrigger().orElseThrow();
    }

    /** Whether an event that is not a time trigger was probably meant to be one. */
    static boolean looksLikeATimer(Event event) {
        return LIKE_A_TIMER.matcher(event.name()).matches();
    }

    private void likeATimer(Transition transition) {
        if (looksLikeATimer(transition.event())
                && likeTimers.add(transition.event().trigger())) {
            findings.add(new Finding(
                    Rule.TIMER_CANNOT_FIRE,
                    element(transition),
                    "event " + transition.event() + " of " + name()
                            + " looks like a time trigger but cannot be parsed as one",
                    "write tm(2s) or after 2 s, with the unit ms, s, min or h"));
        }
    }

    private void overlaps(List<Transition> outgoing) {
        Map<Event, Transition> guarded = new HashMap<>();
        Set<Event> reported = new HashSet<>();
        for (Transition transition : outgoing) {
            Event trigger = transition.event().trigger();
            if (transition.event().guards().isEmpty() || guards.shadowOf(transition) != null) {
                continue;
            }
            Transition before = guarded.putIfAbsent(trigger, transition);
            if (before != null && !before.target().equals(transition.target()) && reported.add(trigger)) {
                findings.add(new Finding(
                        Rule.GUARD_OVERLAP,
                        element(transition),
                        "if the guards of " + before + " and " + transition + " of " + name()
                                + " hold at once, the first counts",
                        "nothing, if that is intended; otherwise let one guard exclude the other"));
            }
        }
    }

    /** Reachable states from which no transition leads to another one, although they are not drawn as an end. */
    private void traps() {
        if (machine.states().size() == 1) {
            return;
        }
        for (State state : reachableAsDrawn()) {
            boolean left = machine.transitionsFrom(state).stream()
                    .anyMatch(transition -> !transition.target().equals(state) && guards.shadowOf(transition) == null);
            if (!left && !machine.isEnd(state)) {
                findings.add(new Finding(
                        Rule.TRAP_STATE,
                        new Element.OfState(side, state),
                        "state " + state + " of " + name() + " cannot be left",
                        "draw a transition to another state"));
            }
        }
    }
}
