package org.evoloop.roomba;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import org.evoloop.evolution.ModelPair;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.ModelException;
import org.evoloop.statemachine.State;
import org.evoloop.statemachine.StateMachine;

/**
 * Assigns functions to new states: by {@code --function STATE=NAME}, else by the state's do activity, else each
 * function to the only new state that is left by the event with which it finishes. All problems are reported at once,
 * in terms of the command line.
 */
final class FunctionBinding {
    private final ModelPair pair;
    private final StateMachine evolved;
    private final Map<State, RobotFunction> bound = new LinkedHashMap<>();
    private final List<String> problems = new ArrayList<>();

    private FunctionBinding(ModelPair pair) {
        this.pair = pair;
        this.evolved = pair.evolved();
    }

    /**
     * The function of each new state that has one; states without one are left by time triggers.
     *
     * @param wanted each {@code STATE=NAME}
     * @throws ModelException if a new state has no function, or one that does not fit
     */
    static Map<State, RobotFunction> bind(ModelPair pair, List<String> wanted) {
        FunctionBinding binding = new FunctionBinding(pair);
        wanted.forEach(binding::bind);
        binding.bindActivities();
        binding.bindTheOne(RobotFunction.MOVE);
        binding.bindTheOne(RobotFunction.SPOT_WAIT);
        binding.requireFunctions();
        binding.requireNoMore();
        if (!binding.problems.isEmpty()) {
            throw new ModelException("this program cannot carry out '"
                    + pair.evolved().name() + "':\n  " + String.join("\n  ", binding.problems));
        }
        return binding.bound;
    }

    private void bind(String wish) {
        int equals = wish.lastIndexOf('=');
        String name = wish.substring(equals + 1).strip();
        RobotFunction function = RobotFunction.of(name).orElse(null);
        if (equals <= 0 || function == null) {
            problems.add("--function " + wish + ": write STATE=FUNCTION; the functions are " + RobotFunction.NAMES);
            return;
        }
        String stateName = wish.substring(0, equals).strip();
        State state = newStates().stream()
                .filter(known -> known.name().equals(stateName))
                .findFirst()
                .orElse(null);
        if (state == null) {
            problems.add("--function " + wish + ": '" + stateName + "' is no new state; there "
                    + (newStates().isEmpty() ? "is none" : "are " + names(newStates())));
        } else if (!fits(function, state)) {
            problems.add("--function " + wish + ": " + function + " finishes with " + function.lastEvent()
                    + ", which does not leave " + state + "; draw a transition for it");
        } else if (bound.put(state, function) != null) {
            problems.add("--function " + wish + ": " + state + " has been given a function before; keep one of them");
        }
    }

    private void bindActivities() {
        for (State state : newStates()) {
            for (String activity : evolved.activities(state)) {
                RobotFunction.of(activity)
                        .filter(function -> fits(function, state))
                        .ifPresent(function -> bound.putIfAbsent(state, function));
            }
        }
    }

    private boolean fits(RobotFunction function, State state) {
        return switch (function) {
            case MOVE, QUIET_HOURS -> function.finishesIn(evolved, state);
            case SPOT_WAIT -> function.finishesIn(evolved, state) || isTimed(state);
            case SPOT_CLEAN -> evolved.hasTrigger(state, new Event(RobotEvents.END_SPOT));
            case CHARGE -> evolved.hasTrigger(state, new Event(RobotEvents.CHARGED));
            case NONE -> true;
        };
    }

    private void bindTheOne(RobotFunction function) {
        if (bound.containsValue(function)) {
            return;
        }
        List<State> candidates = newStates().stream()
                .filter(state -> !bound.containsKey(state) && function.finishesIn(evolved, state))
                .toList();
        if (candidates.size() == 1) {
            bound.put(candidates.get(0), function);
        } else if (candidates.size() > 1) {
            problems.add("new states " + names(candidates) + " are all left by " + function.lastEvent()
                    + "; say in which of them " + function + " runs, for example --function " + candidates.get(0) + "="
                    + function);
            candidates.forEach(state -> bound.put(state, RobotFunction.NONE));
        }
    }

    private void requireFunctions() {
        for (State state : newStates()) {
            if (!bound.containsKey(state) && !isTimed(state)) {
                problems.add("new state " + state + " has no function. Move runs in the state that arriveSpot leaves, "
                        + "SpotWait in the one that timeout leaves; draw such a transition, or a time trigger such as "
                        + "tm(2s), or give --function " + state + "=none if nothing has to run there");
            }
        }
    }

    /** Guards and effects that only the new model has would need code, which this program does not have. */
    private void requireNoMore() {
        for (String guard : evolved.guards()) {
            problems.add(
                    "guard [" + guard + "] of the new model is unknown to this program; draw the model without it");
        }
        List<String> ofDevice = effects(pair.original());
        for (String effect : effects(evolved)) {
            if (!ofDevice.contains(effect)) {
                problems.add(
                        "effect " + effect + " of the new model is unknown to this program; draw the model without it");
            }
        }
    }

    private static List<String> effects(StateMachine machine) {
        return machine.transitions().stream()
                .flatMap(transition -> transition.effects().stream())
                .distinct()
                .toList();
    }

    private boolean isTimed(State state) {
        return !evolved.timers(state).isEmpty();
    }

    private List<State> newStates() {
        return evolved.states().stream().filter(pair::isNew).toList();
    }

    private static String names(List<State> states) {
        return states.stream().map(State::name).collect(Collectors.joining(", "));
    }
}
