package org.evoloop.converter.binding;

import static java.util.Objects.requireNonNull;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import java.util.concurrent.ConcurrentHashMap;
import java.util.function.BiConsumer;
import java.util.function.Predicate;
import java.util.function.ToIntFunction;
import org.evoloop.evolution.DecisionTable;
import org.evoloop.evolution.DeviceEvents;
import org.evoloop.evolution.ModelPair;
import org.evoloop.evolution.Occurrence;
import org.evoloop.evolution.OnFailure;
import org.evoloop.evolution.Values;
import org.evoloop.loop.Failure;
import org.evoloop.loop.LoopConfig;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.Names;
import org.evoloop.statemachine.State;
import org.evoloop.statemachine.StateMachine;
import org.evoloop.statemachine.Transition;
import org.jspecify.annotations.Nullable;

/**
 * The code behind the guards and effects of the models, and the costs of paths through the device's states.
 *
 * <p>Threading: filled before the converter is built, read from any thread after.
 */
public final class Bindings implements Predicate<String> {
    /** The code of an effect. */
    @FunctionalInterface
    public interface Action {
        /** Runs it for an event with {@code values}. */
        void run(Values values) throws Exception;
    }

    private final ModelPair pair;

    /** The guards of the original model. Only those of the event that comes are asked: others may need other values. */
    private final Map<Event, Set<String>> ofDevice;

    private final Map<String, Predicate<Values>> guards = new HashMap<>();
    private final Map<String, GuardWatch> watches = new ConcurrentHashMap<>();
    private final Map<String, Action> effects = new HashMap<>();
    private final Map<Event, Integer> costs = new LinkedHashMap<>();
    private final Map<Event, ToIntFunction<Values>> preferences = new LinkedHashMap<>();
    private final Set<State> doNotPass = new HashSet<>();
    private final Map<State, Map<String, OnFailure>> onFailure = new LinkedHashMap<>();

    public Bindings(ModelPair pair) {
        this.pair = pair;
        this.ofDevice = byEvent(pair.original());
    }

    /** Returns what was bound before. */
    public @Nullable Predicate<Values> guard(String text, Predicate<Values> condition) {
        return guards.put(requireNonNull(text, "the text of a guard is null"), condition);
    }

    /** Returns what was bound before. */
    public @Nullable Action effect(String text, Action effect) {
        return effects.put(requireNonNull(text, "the text of an effect is null"), effect);
    }

    public void cost(String event, int cost) {
        if (cost < 1 || cost > DeviceEvents.MAX_COST) {
            throw new IllegalArgumentException(
                    "the cost of " + event + " is " + cost + ", allowed is 1 to " + DeviceEvents.MAX_COST);
        }
        costs.put(new Event(event), cost);
    }

    public void cost(String event, ToIntFunction<Values> cost) {
        preferences.put(new Event(event), cost);
    }

    /** Whether costs depend on the values of events, or on readings. */
    public boolean prefers() {
        return !preferences.isEmpty();
    }

    /** The costs of events now, for an event with these values. */
    public Map<Event, Integer> costs(Values values) {
        Map<Event, Integer> now = new LinkedHashMap<>(costs);
        preferences.forEach((event, cost) -> now.put(event, cost.applyAsInt(values)));
        return now;
    }

    public void doNotPass(String state) {
        doNotPass.add(new State(state));
    }

    /** Returns the previous setting. */
    public @Nullable OnFailure onFailure(String state, String event, OnFailure then) {
        Map<String, OnFailure> inState = onFailure.computeIfAbsent(new State(state), first -> new LinkedHashMap<>());
        return inState.put(requireNonNull(event, "the event is null"), requireNonNull(then, "what follows is null"));
    }

    /** Whether the guard of this text holds now for an event without values; false if nothing is bound to it. */
    @Override
    public boolean test(String text) {
        return holds(text, Values.NONE);
    }

    /** The guards that {@code machine} draws, by the events that they guard. */
    public static Map<Event, Set<String>> byEvent(StateMachine machine) {
        Map<Event, Set<String>> drawn = new HashMap<>();
        for (Transition transition : machine.transitions()) {
            Event event = transition.event();
            if (!event.guards().isEmpty()) {
                drawn.computeIfAbsent(event.trigger(), first -> new TreeSet<>()).addAll(event.guards());
            }
        }
        return drawn;
    }

    /** The guards that the original model draws for {@code event} and that hold now. One that throws does not hold. */
    public Set<String> holding(Event event, Values values) {
        Set<String> drawn = ofDevice.getOrDefault(event, Set.of());
        return holding(drawn, drawn, values);
    }

    /**
     * Those of {@code asked} that hold now for an event with {@code values}. One that throws counts as false: the
     * device's action is reported all the same.
     *
     * @param drawn those drawn for the event; others may need other values, so it is no failure if they throw
     */
    public Set<String> holding(Set<String> asked, Set<String> drawn, Values values) {
        if (asked.isEmpty()) {
            return Set.of();
        }
        Set<String> holding = new TreeSet<>();
        for (String text : asked) {
            try {
                if (holds(text, values, drawn.contains(text))) {
                    holding.add(text);
                }
            } catch (RuntimeException | Error failure) {
                // The watch has counted it, if it counts.
            }
        }
        return holding;
    }

    /** The same for an event that carries {@code values}. */
    public Predicate<String> with(Values values) {
        return values.isEmpty() ? this : text -> holds(text, values);
    }

    private boolean holds(String text, Values values) {
        return holds(text, values, true);
    }

    private boolean holds(String text, Values values, boolean counts) {
        Predicate<Values> condition = guards.get(text);
        GuardWatch watch = watches.get(text);
        return condition != null && (watch == null ? condition.test(values) : watch.test(condition, values, counts));
    }

    /**
     * Starts watching guards: exceptions are counted, and a guard that hangs is not evaluated again until it returns.
     *
     * @param failures receives the failures, each with what failed, such as {@code guard [full]}
     */
    public void watch(LoopConfig config, BiConsumer<String, Failure<Occurrence>> failures) {
        for (String text : guards.keySet()) {
            watches.put(text, new GuardWatch(text, config, failures));
        }
    }

    /** The guards that are being evaluated now. */
    public List<String> asked() {
        List<String> asked = new ArrayList<>();
        for (Map.Entry<String, GuardWatch> watch : watches.entrySet()) {
            if (watch.getValue().isAsked()) {
                asked.add(watch.getKey());
            }
        }
        return asked;
    }

    /**
     * Runs an effect.
     *
     * @throws IllegalStateException if nothing is bound to {@code text}
     */
    public void run(String text, Values values) throws Exception {
        Action effect = effects.get(text);
        if (effect == null) {
            throw new IllegalStateException("nothing is bound to it; call effect in registerNewFunctions");
        }
        effect.run(values);
    }

    /** {@code device} with the costs of paths and the guards that are bound. */
    public DeviceEvents refine(DeviceEvents device) {
        return device.withCosts(costs)
                .withDoNotPass(doNotPass)
                .withBoundGuards(guards.keySet())
                .withOnFailure(onFailure);
    }

    /** Problems with the bindings, a line each; see {@code KnowledgeAccess.problems}. */
    public List<String> problems(boolean leftOver) {
        List<String> problems = new ArrayList<>(leftOver ? leftOver() : List.of());
        for (String text : pair.evolved().guards()) {
            if (!guards.containsKey(text)) {
                problems.add("guard [" + text + "] of the new model is not bound: call guard in registerNewFunctions");
            }
        }
        return problems;
    }

    private List<String> leftOver() {
        List<String> problems = new ArrayList<>();
        Set<String> drawnGuards = new HashSet<>(pair.original().guards());
        drawnGuards.addAll(pair.evolved().guards());
        for (String text : guards.keySet()) {
            if (!drawnGuards.contains(text)) {
                problems.add("guard [" + text + "] is bound, but drawn in neither model");
            }
        }
        for (String text : effects.keySet()) {
            if (!draws(pair.evolved(), text)) {
                problems.add("effect " + text + " is bound, but the new model does not draw it");
            }
        }
        Set<Event> priced = new LinkedHashSet<>(costs.keySet());
        priced.addAll(preferences.keySet());
        for (Event event : priced) {
            if (!pair.original().triggers().contains(event)) {
                problems.add("a cost is given to " + event + ", which is not an event of the original model"
                        + Names.hint(event.name(), pair.original().triggers()));
            }
        }
        for (State state : doNotPass) {
            if (pair.original().alike(state).isEmpty()) {
                problems.add(state + " is not to be passed, but is not a state of the original model"
                        + Names.hint(state.name(), pair.original().states()));
            }
        }
        onFailure.forEach((state, byEvent) -> byEvent.keySet().stream()
                .filter(event -> !leaves(state, event))
                .forEach(event -> problems.add("it is said what follows when a plan for " + event + " in " + state
                        + " breaks off, but the new model has no such transition")));
        return problems;
    }

    private boolean leaves(State state, String event) {
        return pair.evolved().hasState(state)
                && pair.evolved().transitionsFrom(state).stream()
                        .map(Transition::event)
                        .anyMatch(drawn -> drawn.toString().equals(event)
                                || drawn.trigger().name().equals(event));
    }

    private static boolean draws(StateMachine machine, String effect) {
        for (Transition transition : machine.transitions()) {
            if (transition.effects().contains(effect)) {
                return true;
            }
        }
        return false;
    }

    /** Effects that decisions of {@code table} need but that are not bound, a line each. */
    public List<String> unboundEffects(DecisionTable table) {
        List<String> unbound = new ArrayList<>();
        for (String text : table.effects()) {
            if (!effects.containsKey(text)) {
                unbound.add("effect " + text + " of the new model is not bound: call effect in registerNewFunctions");
            }
        }
        return unbound;
    }
}
