package org.evoloop.converter;

import static java.util.Objects.requireNonNull;

import java.time.Duration;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.function.BooleanSupplier;
import java.util.function.Predicate;
import java.util.function.Supplier;
import java.util.function.ToIntFunction;
import org.evoloop.converter.attachment.Friends;
import org.evoloop.converter.attachment.KnowledgeAccess;
import org.evoloop.converter.binding.Bindings;
import org.evoloop.evolution.Configuration;
import org.evoloop.evolution.DeviceEvents;
import org.evoloop.evolution.EventNames;
import org.evoloop.evolution.ModelPair;
import org.evoloop.evolution.OnFailure;
import org.evoloop.evolution.Values;
import org.evoloop.function.NewFunction;
import org.evoloop.loop.Knowledge;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.Names;
import org.evoloop.statemachine.State;
import org.evoloop.statemachine.StateMachine;
import org.evoloop.statemachine.Transition;
import org.evoloop.time.Clock;
import org.jspecify.annotations.Nullable;

/**
 * The knowledge of a converter: both models, their current states, and the functions of new states (paper, section
 * V.B). Extend it and register the functions in {@link #registerNewFunctions}.
 *
 * <p>Threading: the methods that register are for {@link #registerNewFunctions} and before; the rest is thread-safe.
 *
 * @since 0.1
 */
public class StateKnowledge extends Knowledge {
    static {
        Friends.KNOWLEDGE.give(knowledge -> ((StateKnowledge) knowledge).access);
    }

    private final KnowledgeAccess access = new Access();
    private final StateMachine drawn;

    /** With the device states and sends that {@link #registerNewFunctions} adds. */
    private ModelPair pair;

    private final Map<State, NewFunction> functions = new HashMap<>();
    private final Map<State, Map<Event, Duration>> timers = new HashMap<>();

    /** Those and the time triggers of the new model, by state; filled on demand. */
    private final Map<State, Map<Event, Duration>> allTimers = new ConcurrentHashMap<>();

    private final Map<Ends, NewFunction> actions = new HashMap<>();
    private final Bindings bindings;
    private final EventNames eventNames;

    /** Names registered more than once, a line each. */
    private final Set<String> repeated = new LinkedHashSet<>();

    /** States of a use of the device that the new model does not have, a line each. */
    private final Set<String> misnamed = new LinkedHashSet<>();

    private boolean registered;
    private volatile @Nullable Supplier<Configuration> place;

    /** @throws org.evoloop.statemachine.ModelException if the pair violates Condition 1 or 2 */
    public StateKnowledge(ModelPair pair) {
        requireNonNull(pair, "the models are null").requireValid();
        this.pair = pair;
        this.drawn = pair.evolved();
        this.bindings = new Bindings(pair);
        this.eventNames = EventNames.of(pair);
    }

    private final class Access implements KnowledgeAccess {
        @Override
        public void register() {
            if (!registered) {
                registerNewFunctions();
                pair.requireValid();
                registered = true;
            }
        }

        @Override
        public List<String> problems(boolean leftOver) {
            return StateKnowledge.this.problems(leftOver);
        }

        @Override
        public Bindings bindings() {
            return bindings;
        }

        @Override
        public EventNames eventNames() {
            return eventNames;
        }

        @Override
        public Map<Event, Duration> timersOf(State state) {
            return StateKnowledge.this.timersOf(state);
        }

        @Override
        public NewFunction action(Transition transition) {
            return StateKnowledge.this.action(transition);
        }

        @Override
        public State located(String name) {
            State state = new State(name);
            if (!pair.original().hasState(state)) {
                throw new IllegalStateException("the device says that it is in " + Names.shown(name)
                        + ", which is not a state of its model"
                        + Names.hint(name, pair.original().states()));
            }
            return state;
        }

        @Override
        public void attach(@Nullable Supplier<Configuration> kept) {
            place = kept;
        }
    }

    /** A transition as its author names it: its event with or without guards. */
    private record Ends(State source, String event, State target) {
        /** For messages: {@code Off --Clean--> On}. */
        @Override
        public String toString() {
            return source + " --" + event + "--> " + target;
        }
    }

    /** Registers the functions and timers of new states; called once, when the converter is built. */
    protected void registerNewFunctions() {}

    /**
     * Runs {@code function} whenever the new state {@code state} is entered, whatever history the new model then
     * remembers.
     */
    protected final void function(String state, NewFunction function) {
        requireNonNull(function, "the function of " + state + " is null; NewFunction.none() does nothing");
        for (State each : drawn(state)) {
            noteIfRepeated("a function", state, functions.put(each, function));
        }
    }

    private void noteIfRepeated(String what, String where, @Nullable Object before) {
        if (before != null) {
            repeated.add(what + " is registered twice for " + where + "; keep one");
        }
    }

    /** All that a state as drawn is, or the one that is named with what is remembered in it, or that does not exist. */
    private List<State> drawn(String name) {
        State state = new State(name);
        List<State> all = pair.evolved().alike(state);
        return all.isEmpty() || !pair.evolved().withoutMemory(state).equals(state) ? List.of(state) : all;
    }

    /**
     * Says that the device must be in {@code deviceState} while the new state {@code state} lasts, as the model can, too.
     *
     * @param deviceState the name of a state of the original model, or its path
     */
    protected final void device(String state, String deviceState) {
        for (State each : used(state)) {
            String known = pair.evolved().deviceState(each);
            if (known != null && !known.equals(deviceState)) {
                repeated.add(
                        "state " + each + " has two device states, " + known + " and " + deviceState + "; keep one");
            } else {
                pair = new ModelPair(pair.original(), pair.evolved().withDeviceState(each, deviceState));
            }
        }
    }

    /**
     * Says that the function of the new state {@code state} may send {@code event} to the device, as the model can, too:
     * a model that says what the function sends has to say all of it. What neither says is refused when the function
     * asks for it. Checks of the model need to be told what only the code says.
     */
    protected final void sends(String state, String event) {
        Event sent = new Event(event);
        for (State each : used(state)) {
            Set<Event> known = drawn.sends(each);
            if (!known.isEmpty() && !known.contains(sent)) {
                repeated.add("the function of " + each + " sends " + event + ", but the new model draws that it sends "
                        + String.join(
                                ", ", known.stream().map(Event::name).sorted().toList())
                        + " only; draw " + event + ", too, or remove it from the code");
            } else {
                pair = new ModelPair(pair.original(), pair.evolved().withSends(each, sent));
            }
        }
    }

    /**
     * Says that {@code event} is urgent, as the model can, too: it has a place in the queue that no other can take, goes
     * before all other requests, and ends the plan in progress between two steps.
     */
    protected final void urgent(String event) {
        Event known = new Event(event);
        if (pair.evolved().triggers().contains(known)) {
            pair = new ModelPair(pair.original(), pair.evolved().withUrgent(known));
        } else {
            misnamed.add("an event is registered as urgent, " + event + ", which is not an event of the new model"
                    + Names.hint(event, pair.evolved().triggers()));
        }
    }

    /** The states of this name, whose use of the device is registered. */
    private List<State> used(String name) {
        List<State> all = drawn(name);
        if (pair.evolved().hasState(all.get(0))) {
            return all;
        }
        misnamed.add("a use of the device is registered for " + name + ", which is not a state of the new model"
                + Names.hint(name, pair.evolved().states()));
        return List.of();
    }

    /**
     * Raises {@code event} when {@code state} has lasted for {@code delay}; a drawn {@code tm(2s)} needs no call.
     */
    protected final void timer(String state, String event, Duration delay) {
        requireNonNull(delay, "the delay of " + event + " in " + state + " is null");
        for (State during : drawn(state)) {
            Map<Event, Duration> ofState = timers.computeIfAbsent(during, key -> new LinkedHashMap<>());
            noteIfRepeated("a timer", event + " in " + state, ofState.put(new Event(event), delay));
        }
        allTimers.clear();
    }

    /**
     * Binds the guard of this text, drawn in brackets in either model. It is evaluated on the analyze component's thread when an event
     * comes that the new model guards with it, on an execute component's thread before an event is sent over a
     * guarded transition of the original model, and on the thread that reports an event which the original model guards
     * with it. If it throws, that event fails; what the device has done by itself counts as if it did not hold.
     */
    protected final void guard(String text, BooleanSupplier condition) {
        requireNonNull(condition, "the guard " + text + " is null");
        guard(text, values -> condition.getAsBoolean());
    }

    /** As {@link #guard(String, BooleanSupplier)}, for a guard that uses the event's values. */
    protected final void guard(String text, Predicate<Values> condition) {
        requireNonNull(condition, "the guard " + text + " is null");
        noteIfRepeated("a guard", text, bindings.guard(text, condition));
    }

    /**
     * Binds the effect of this text. It runs when a transition of the new model that names it is taken, after the
     * device has obeyed and before the next state is entered. It does not run where the device does it by itself,
     * because a transition of the original model in the plan names it too. If it throws, the event fails, but the
     * transition is taken and its other effects are run.
     */
    protected final void effect(String text, Effect action) {
        requireNonNull(action, "the effect " + text + " is null");
        effect(text, values -> action.run());
    }

    /** As {@link #effect(String, Effect)}, for an effect that uses the event's values. */
    protected final void effect(String text, Effect.OfEvent action) {
        requireNonNull(action, "the effect " + text + " is null");
        noteIfRepeated("an effect", text, bindings.effect(text, action::run));
    }

    /**
     * Sets the cost of sending {@code event}; plans minimise the total cost.
     *
     * @param event of the original model
     * @param cost the default of an event is 1
     * @throws IllegalArgumentException if {@code cost} is not from 1 to {@value DeviceEvents#MAX_COST}
     */
    protected final void cost(String event, int cost) {
        bindings.cost(event, cost);
    }

    /**
     * As {@link #cost(String, int)}, for a cost that depends on the values of the event, or on readings. It is asked when
     * a request is decided, and the plan is recorded. In a fleet and after a failed step, the fixed cost counts. If it
     * throws, or is out of range, the event fails.
     */
    protected final void cost(String event, ToIntFunction<Values> cost) {
        bindings.cost(event, requireNonNull(cost, "a cost is null"));
    }

    /**
     * Keeps plans of several events from passing through {@code state} of the device; they may begin or end there.
     */
    protected final void doNotPass(String state) {
        bindings.doNotPass(state);
    }

    /**
     * Sets what follows when a step of a plan fails and leaves the device in an intermediate state, by default nothing.
     *
     * @param state the state of the new model in which the event comes
     * @param event the event, with its guards, as in {@code press [hot]}, if only that transition is meant
     */
    protected final void onFailure(String state, String event, OnFailure then) {
        noteIfRepeated("what follows on failure", event + " in " + state, bindings.onFailure(state, event, then));
    }

    /**
     * Registers the function that runs when one transition of the new model is taken, in place of the function of its
     * target.
     *
     * @param source the current state (the paper's s0)
     * @param target the next state (s1), a new one
     * @param action the function to be called
     * @param event the incoming event; with its guards, as in {@code press [hot]}, if only that transition is meant
     */
    public final void putTransition(String source, String target, NewFunction action, String event) {
        Ends ends = new Ends(new State(source), requireNonNull(event, "the event is null"), new State(target));
        requireNonNull(action, "the action of " + ends + " is null; NewFunction.none() does nothing");
        noteIfRepeated("an action", ends.toString(), actions.put(ends, action));
    }

    /** The transition of the new model that {@code event} triggers in {@code source}, with its function. */
    public final Optional<BoundTransition> getTransition(State source, Event event) {
        Transition transition = pair.evolved().transition(source, event).orElse(null);
        return transition == null
                ? Optional.empty()
                : Optional.of(new BoundTransition(source, event, transition.target(), action(transition)));
    }

    private NewFunction action(Transition transition) {
        NewFunction action = ownAction(transition);
        return action != null ? action : functions.getOrDefault(transition.target(), NewFunction.none());
    }

    private @Nullable NewFunction ownAction(Transition transition) {
        if (actions.isEmpty()) {
            return null;
        }
        Event event = transition.event();
        NewFunction action = actions.get(new Ends(transition.source(), event.toString(), transition.target()));
        return action != null ? action : actions.get(new Ends(transition.source(), event.name(), transition.target()));
    }

    private Map<Event, Duration> timersOf(State state) {
        Map<Event, Duration> known = allTimers.get(state);
        if (known == null) {
            known = collectTimers(state);
            allTimers.put(state, known);
        }
        return known;
    }

    private Map<Event, Duration> collectTimers(State state) {
        Map<Event, Duration> all = new LinkedHashMap<>(timers.getOrDefault(state, Map.of()));
        all.putAll(pair.evolved().timers(state));
        return all;
    }

    /** Both models. */
    public final ModelPair models() {
        return pair;
    }

    /** The current state of the new model. */
    public final State getCurrentState() {
        return configuration().evolved();
    }

    /** The current state of the original model: where the device is. */
    public final State getOriginalState() {
        return configuration().original();
    }

    /** The current states of both models at one moment. */
    public final Configuration configuration() {
        Supplier<Configuration> attached = place;
        return attached == null ? pair.initial() : attached.get();
    }

    private List<String> problems(boolean leftOver) {
        List<String> problems = new ArrayList<>(repeated);
        if (leftOver) {
            leftOver(problems);
        }
        for (State state : functions.keySet()) {
            if (pair.evolved().hasState(state) && !pair.isNew(state)) {
                problems.add("a function is registered for " + state + ", but the device itself has that state");
            }
        }
        for (Map.Entry<State, Map<Event, Duration>> ofState : timers.entrySet()) {
            for (Event event : ofState.getValue().keySet()) {
                if (event.timeTrigger().isPresent()) {
                    problems.add("a timer raises " + event + " in " + ofState.getKey()
                            + ", which the new model does by itself; register none");
                }
            }
        }
        for (State state : pair.evolved().states()) {
            timersOf(state).forEach((event, delay) -> {
                if (delay.isNegative() || delay.compareTo(Clock.LONGEST) > 0) {
                    problems.add("the timer that raises " + event + " in " + state + " has the delay " + delay
                            + ", allowed is 0 to " + Clock.LONGEST.toDays() + " days");
                }
            });
        }
        for (Ends ends : actions.keySet()) {
            if (isDrawn(ends) && !pair.isNew(ends.target())) {
                problems.add("an action is registered for " + ends + ", but its target is a state of the device");
            }
        }
        for (State state : pair.evolved().states()) {
            if (pair.isNew(state) && !isCovered(state)) {
                problems.add("new state " + state + " has no function: register one in registerNewFunctions, "
                        + "NewFunction.none() if nothing has to run");
            }
        }
        deferredUnderGuards(problems);
        problems.addAll(bindings.problems(leftOver));
        return problems;
    }

    /** Registrations for names that the models do not have. */
    private void leftOver(List<String> problems) {
        problems.addAll(misnamed);
        for (State state : functions.keySet()) {
            if (!pair.evolved().hasState(state)) {
                problems.add("a function is registered for " + state + ", which is not a state of the new model"
                        + Names.hint(state.name(), pair.evolved().states()));
            }
        }
        for (Map.Entry<State, Map<Event, Duration>> ofState : timers.entrySet()) {
            for (Event event : ofState.getValue().keySet()) {
                if (!pair.evolved().hasTrigger(ofState.getKey(), event)) {
                    problems.add("a timer raises " + event + " in " + ofState.getKey()
                            + ", where the new model has no transition for it"
                            + (eventNames.knows(event) ? "" : ": " + eventNames.unknown(event)));
                }
            }
        }
        for (Ends ends : actions.keySet()) {
            if (!isDrawn(ends)) {
                problems.add("an action is registered for " + ends + ", which the new model does not have");
            }
        }
    }

    /** An event is deferred before any guard is evaluated. */
    private void deferredUnderGuards(List<String> problems) {
        for (State state : pair.evolved().states()) {
            for (Event event : pair.evolved().deferred(state)) {
                for (Transition transition : pair.evolved().transitionsFrom(state)) {
                    if (!transition.event().guards().isEmpty()
                            && transition.event().name().equals(event.name())) {
                        problems.add("the new model defers " + event.name() + " in " + state
                                + " unless a guard holds, which a converter cannot tell beforehand; draw the guard on a"
                                + " transition of the state that the event waits for");
                    }
                }
            }
        }
    }

    private boolean isDrawn(Ends ends) {
        for (Transition transition : pair.evolved().transitionsFrom(ends.source())) {
            Event event = transition.event();
            if (ends.target().equals(transition.target())
                    && (ends.event().equals(event.name()) || ends.event().equals(event.toString()))) {
                return true;
            }
        }
        return false;
    }

    private boolean isCovered(State state) {
        if (functions.containsKey(state) || !timersOf(state).isEmpty()) {
            return true;
        }
        boolean entered = false;
        for (Transition transition : pair.evolved().transitions()) {
            if (transition.target().equals(state) && !transition.internal()) {
                entered = true;
                if (ownAction(transition) == null) {
                    return false;
                }
            }
        }
        return entered;
    }
}
