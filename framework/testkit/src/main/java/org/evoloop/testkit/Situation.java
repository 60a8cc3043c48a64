package org.evoloop.testkit;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Queue;
import java.util.Set;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.State;
import org.evoloop.statemachine.StateMachine;
import org.evoloop.statemachine.Transition;

/**
 * A command during which a device acts by itself, where the order of the two determines the final state.
 *
 * @param way the events that lead there from the start: sent, or the device's own
 * @param before whether the device acts just before it takes the command, or just after
 */
record Situation(List<String> way, State at, String command, String own, boolean before) {

    /** For messages. */
    @Override
    public String toString() {
        return "when " + command + " is sent in " + at + ", and the device does " + own + " by itself just "
                + (before ? "before" : "after") + " it takes " + command;
    }

    /** All situations of a model, without guarded transitions. */
    static List<Situation> all(StateMachine model, Set<String> sendable, Set<String> own) {
        List<Situation> all = new ArrayList<>();
        ways(model, sendable, own).forEach((at, way) -> {
            for (String command : sendable) {
                for (String act : own) {
                    if (next(model, at, command).isPresent()) {
                        State commandFirst = after(model, after(model, at, command), act);
                        State actFirst = after(model, after(model, at, act), command);
                        boolean matters = !commandFirst.equals(actFirst);
                        if (matters && next(model, at, act).isPresent()) {
                            all.add(new Situation(way, at, command, act, true));
                        }
                        if (matters
                                && next(model, after(model, at, command), act).isPresent()) {
                            all.add(new Situation(way, at, command, act, false));
                        }
                    }
                }
            }
        });
        return all;
    }

    private static Map<State, List<String>> ways(StateMachine model, Set<String> sendable, Set<String> own) {
        Map<State, List<String>> ways = new LinkedHashMap<>(Map.of(model.initial(), List.of()));
        Queue<State> toVisit = new ArrayDeque<>(List.of(model.initial()));
        for (State at = toVisit.poll(); at != null; at = toVisit.poll()) {
            List<String> way = ways.getOrDefault(at, List.of());
            for (Transition transition : model.transitionsFrom(at)) {
                String event = transition.event().name();
                boolean possible =
                        transition.event().guards().isEmpty() && (sendable.contains(event) || own.contains(event));
                if (possible && !ways.containsKey(transition.target())) {
                    List<String> longer = new ArrayList<>(way);
                    longer.add(event);
                    ways.put(transition.target(), longer);
                    toVisit.add(transition.target());
                }
            }
        }
        return ways;
    }

    private static Optional<State> next(StateMachine model, State at, String event) {
        return model.nextState(at, new Event(event));
    }

    private static State after(StateMachine model, State at, String event) {
        return next(model, at, event).orElse(at);
    }
}
