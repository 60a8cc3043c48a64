package org.evoloop.evolution;

import static java.util.Objects.requireNonNull;

import java.util.ArrayList;
import java.util.Collections;
import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.function.Predicate;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.State;
import org.evoloop.statemachine.Transition;
import org.jspecify.annotations.Nullable;

/**
 * The transition hash table: the decision for every event in every reachable configuration, computed once, so that
 * deciding at run time is a look-up. Situations and events are numbered to make it fast.
 *
 * <p>Reachable means by expected events: requested by a controller, a timer or a function, or taken by the device where
 * its model says that it can. What the device may do by itself although it can also be sent, such as react to its own
 * buttons, is explored last. Thus a decision that cannot be carried out is known to be either a {@linkplain #problems()
 * problem} of the models or a {@linkplain #hazards() hazard} of such interference. After a plan failed between two
 * steps, the system may be in another configuration; decisions there are computed when first needed.
 *
 * <p>Threading: thread-safe.
 *
 * @since 0.1
 */
public final class DecisionTable {
    private final ModelPair pair;
    private final DeviceEvents device;
    private final EventNames names;

    private final EventConversion conversion;
    private final GuardedTriggers originalGuards;
    private final GuardedTriggers evolvedGuards;
    private final Turns turns;
    /** In the order in which they were reached, which is the order of their numbers. */
    private final Map<Configuration, Integer> situations = new LinkedHashMap<>();
    /** The configurations by number, including those still to be explored. */
    private final List<Configuration> reached = new ArrayList<>();

    private int explored;

    private final Map<Event, Integer> numbers = new HashMap<>();
    private final Map<String, Integer> numbersByName = new HashMap<>();
    private final Company company;
    private final DecisionCells asked;
    private final DecisionCells acted;
    private final List<Decision> ignored = new ArrayList<>();
    private final Set<Decision.Impossible> problems = new LinkedHashSet<>();
    private final Set<Decision.Impossible> hazards = new LinkedHashSet<>();

    private DecisionTable(ModelPair pair, DeviceEvents device) {
        this.pair = pair;
        this.device = device.declaredBy(pair.original());
        this.conversion = new EventConversion(pair, this.device);
        this.names = EventNames.of(pair);
        this.originalGuards = new GuardedTriggers(pair.original());
        this.evolvedGuards = new GuardedTriggers(pair.evolved());
        this.company = new Company(pair, conversion, situations, reached);
        this.turns = new Turns(pair, this.device, conversion, originalGuards, evolvedGuards);
        pair.evolved().events().forEach(this::giveNumber);
        pair.original().events().forEach(this::giveNumber);
        this.asked = new DecisionCells(numbers.size());
        this.acted = new DecisionCells(numbers.size());
    }

    private void giveNumber(Event event) {
        numbersByName.putIfAbsent(event.toString(), numbers.size());
        numbers.putIfAbsent(event, numbers.size());
    }

    /**
     * Explores every configuration that is reachable from the initial one.
     *
     * @param pair a valid pair, see {@link ModelPair#requireValid()}
     * @throws NullPointerException if an argument is null; the message says which
     */
    public static DecisionTable compile(ModelPair pair, DeviceEvents device) {
        DecisionTable table = new DecisionTable(
                requireNonNull(pair, "the models are null"), requireNonNull(device, "the device's events are null"));
        table.reach(pair.initial());
        table.explore(false, table.problems);
        int expected = table.reached.size();
        table.company.reachesByExpectedEvents(expected);
        for (int situation = 0; situation < expected; situation++) {
            table.follow(situation, table.interference(table.reached.get(situation), situation), table.hazards);
        }
        table.explore(true, table.hazards);
        table.asked.link(decision -> table.situation(decision.after()));
        return table;
    }

    /** The number of a configuration; one that is new is explored later. */
    private int reach(Configuration at) {
        Integer known = situations.get(at);
        if (known == null) {
            known = reached.size();
            situations.put(at, known);
            reached.add(at);
        }
        return known;
    }

    private void explore(boolean withInterference, Set<Decision.Impossible> impossible) {
        for (; explored < reached.size(); explored++) {
            Configuration at = reached.get(explored);
            fill(at, explored);
            follow(explored, expected(at, explored), impossible);
            if (withInterference) {
                follow(explored, interference(at, explored), impossible);
            }
        }
    }

    private void follow(int situation, List<Turn> coming, Set<Decision.Impossible> impossible) {
        for (Turn turn : coming) {
            if (turn.decision() instanceof Decision.Impossible found) {
                // An event that cannot come is reported once, not in each configuration.
                if (!conversion.isUnsendable(turn.event().trigger())) {
                    impossible.add(found);
                }
            } else {
                int next = reach(turn.decision().after());
                if (!turn.deviceActed() && !turn.isSent()) {
                    asked.lead(situation, number(turn.event()), next);
                }
            }
        }
    }

    /**
     * The expected turns in {@code at}: events that the new model accepts, what the device does by itself, and what the
     * function of the state may send.
     */
    public List<Turn> expected(Configuration at) {
        return expected(at, situation(at));
    }

    private List<Turn> expected(Configuration at, int situation) {
        return turns.expected(at, (event, deviceActed) -> decide(at, situation, event, deviceActed));
    }

    /** The turns in {@code at} in which the device does by itself what could have been sent to it. */
    public List<Turn> interference(Configuration at) {
        return interference(at, situation(at));
    }

    private List<Turn> interference(Configuration at, int situation) {
        return turns.interference(at, (event, deviceActed) -> decide(at, situation, event, deviceActed));
    }

    /** Decides all events of either model in {@code at}; any other is ignored there. */
    private void fill(Configuration at, int situation) {
        asked.open(situation);
        acted.open(situation);
        ignored.add(new Decision.NotAcceptable(at, at, List.of()));
        for (Transition known : pair.evolved().transitionsFrom(at.evolved())) {
            fill(at, situation, known.event(), known);
        }
        for (Transition known : pair.original().transitionsFrom(at.original())) {
            fill(at, situation, known.event(), null);
        }
    }

    /** @param transition the new model's transition; null if it has none */
    private void fill(Configuration at, int situation, Event event, @Nullable Transition transition) {
        int number = number(event);
        if (asked.get(situation, number) == null) {
            Transition same = conversion.originalTransition(at.original(), event);
            asked.put(situation, number, conversion.decide(at, event, false, transition, same));
            // If the device is not declared to act by itself, that case is decided when it happens.
            if (same != null && device.spontaneous().contains(event.trigger())) {
                acted.put(situation, number, conversion.decide(at, event, true, transition, same));
            }
        }
    }

    /** The models that it decides for. */
    public ModelPair models() {
        return pair;
    }

    /** The events that either model knows. */
    public EventNames names() {
        return names;
    }

    /** The number of the initial situation, for the fast methods. */
    public int initial() {
        return 0;
    }

    /** The number of a configuration, for the fast methods; {@code -1} if it is not one of {@link #configurations}. */
    public int situation(Configuration at) {
        Integer known = situations.get(at);
        return known == null ? DecisionCells.UNKNOWN : known;
    }

    /** The number of an event, for the fast methods; {@code -1} for one that neither model knows. */
    public int number(Event event) {
        Integer known = numbers.get(event);
        return known == null ? DecisionCells.UNKNOWN : known;
    }

    /** The number of an event by its name, as {@link Event#toString} writes it; {@code -1} if there is none. */
    public int number(String event) {
        Integer known = numbersByName.get(event);
        return known == null ? DecisionCells.UNKNOWN : known;
    }

    /**
     * The decision for a requested event; allocates nothing and computes no hash.
     *
     * @param situation a {@linkplain #situation number} other than {@code -1}
     * @param event a {@linkplain #number(Event) number}; {@code -1} is not acceptable anywhere
     */
    public Decision decide(int situation, int event) {
        Decision decision = event < 0 ? null : asked.get(situation, event);
        return decision == null ? ignored.get(situation) : decision;
    }

    /** As {@link #decide(int, int)}, with the event's name. */
    public Decision decide(int situation, String event) {
        return decide(situation, number(event));
    }

    /** The situation after {@link #decide(int, int)}; {@code -1} if it is not one of {@link #configurations}. */
    public int after(int situation, int event) {
        return event < 0 ? situation : asked.after(situation, event);
    }

    /** As {@link #after(int, int)}, with the event's name. */
    public int after(int situation, String event) {
        return after(situation, number(event));
    }

    /**
     * The decision for {@code event} in {@code at}.
     *
     * @param event the event, with the guards under which it comes, see {@link #resolve}
     * @param deviceActed whether the device has already acted on it
     * @return {@link Decision.NotAcceptable} without steps for an event that neither model knows there
     */
    public Decision decide(Configuration at, Event event, boolean deviceActed) {
        return decide(at, situation(at), event, deviceActed);
    }

    private Decision decide(Configuration at, int situation, Event event, boolean deviceActed) {
        if (situation == DecisionCells.UNKNOWN) {
            return decideNow(at, event, deviceActed);
        }
        int number = number(event);
        Decision expected = number < 0 ? null : asked.get(situation, number);
        if (!deviceActed || expected == null) {
            return decide(situation, number);
        }
        Decision own = acted.get(situation, number);
        if (own != null) {
            return own;
        }
        return conversion.originalTransition(at.original(), event) == null ? expected : decideNow(at, event, true);
    }

    /** The conversion remembers its searches, which is not thread-safe. */
    private synchronized Decision decideNow(Configuration at, Event event, boolean deviceActed) {
        return conversion.decide(at, event, deviceActed);
    }

    /**
     * The new model's decision on {@code event} after the device has acted on it, and possibly moved on: a plan begins
     * in the device's present state, in {@code at}.
     *
     * @param event the event, with the guards under which it comes, see {@link #resolve}
     * @param own the step that the device took; null if its model has none
     * @param follow whether the new model only follows, without sending, where both models agree on the action
     */
    public synchronized Decision react(Configuration at, Event event, @Nullable Step own, boolean follow) {
        return conversion.react(at, event, own, follow);
    }

    /**
     * {@code usual}, the decision for a request, by the path that is cheapest at these costs; an event that leads on by
     * itself is sent whatever it costs.
     *
     * @throws IllegalArgumentException if a cost is out of range
     */
    public synchronized Decision prefer(Decision usual, Map<Event, Integer> costs) {
        return conversion.prefer(usual, costs);
    }

    /**
     * The decision for {@code trigger} that a new function sends to the device. {@link Decision.Impossible} also where
     * the state does not {@linkplain org.evoloop.statemachine.StateMachine#sends declare} that its function sends this,
     * and where it would take the device out of the state's device state.
     */
    public Decision ask(Configuration at, Event trigger, Predicate<String> holds) {
        Event event = originalGuards.resolve(at.original(), trigger, holds);
        Transition taken = event == null ? null : conversion.originalTransition(at.original(), event);
        return conversion.send(
                at,
                trigger.trigger(),
                taken,
                taken != null && !originalGuards.conditionsOf(taken).isEmpty());
    }

    /** Whether only the device itself can take {@code trigger}. */
    public boolean isDevicesOwn(Event trigger) {
        return device.isOwn(trigger);
    }

    /** Whether only the new model has {@code state}: a function that the converter runs. */
    public boolean isNew(State state) {
        return conversion.isNew(state);
    }

    /**
     * The step that the device takes by itself on {@code trigger} in {@code at}; null if its model has none there.
     *
     * @param holds whether the guard of this text holds now; false for an unbound one
     */
    public @Nullable Step ownStep(State at, Event trigger, Predicate<String> holds) {
        Event event = originalGuards.resolve(at, trigger, holds);
        Transition taken = event == null ? null : conversion.originalTransition(at, event);
        return taken == null ? null : new Step(taken, true, false);
    }

    /** Whether the device has {@code trigger} in other states only, so that it cannot have taken it in {@code at}. */
    public boolean isImpossible(State at, Event trigger) {
        return !pair.original().hasTrigger(at, trigger)
                && pair.original().triggers().contains(trigger.trigger());
    }

    /** The state to which {@code trigger} leads the device from wherever it has it; null if there are several. */
    public @Nullable State onlyTarget(Event trigger) {
        State only = null;
        for (Transition transition : pair.original().transitions()) {
            if (transition.event().name().equals(trigger.name())) {
                if (only != null && !only.equals(transition.target())) {
                    return null;
                }
                only = transition.target();
            }
        }
        return only;
    }

    /** Whether guards decide what the device does on {@code trigger} in {@code at}. */
    public boolean isGuarded(State at, Event trigger) {
        return originalGuards.decideOn(at, trigger);
    }

    /**
     * Adds the guards under which {@code trigger} comes: those of the new model, else, when the device may have taken
     * it by itself, those of the original model.
     *
     * @param trigger the event without guards, as a monitor reports it
     * @param holds whether the guard of this text holds now; false for an unbound one
     * @return the event to {@link #decide}; {@code trigger} itself where no guard is drawn for it
     */
    public Event resolve(Configuration at, Event trigger, Predicate<String> holds) {
        Event heard = evolvedGuards.resolve(at.evolved(), trigger, holds);
        if (heard != null && pair.evolved().hasTransition(at.evolved(), heard)) {
            return heard;
        }
        Event taken = originalGuards.resolve(at.original(), trigger, holds);
        return taken == null ? trigger : taken;
    }

    /**
     * Whether {@code event} is deferred in {@code at}: it is not decided, but waits for a state of the new model that
     * does not defer it (UML 2.5.1, clause 14.2.3.4.4). What the device has already done is never deferred.
     *
     * @param event the event, from {@link #resolve}
     */
    public boolean defers(Configuration at, Event event) {
        return pair.evolved().defers(at.evolved(), event);
    }

    /** Whether {@code event} is deferred in any state, so that it may wait for long. */
    public boolean mayDefer(Event event) {
        return pair.evolved().mayDefer(event);
    }

    /** Whether the guards make {@code step} the one that its trigger takes now. */
    public boolean isOpen(Step step, Predicate<String> holds) {
        return !step.conditional() || step.event().equals(originalGuards.resolve(step.source(), step.trigger(), holds));
    }

    /**
     * The decision after the device was found in {@code original}: the new model stays where it is if the two states
     * are a reachable pair, also by the device's interference, or if the device is where the record has it, and both
     * states differ at most in the history that each model remembers; else it follows the device. A new state that
     * needs the device somewhere is kept exactly if the device is there. Of several states that differ only in the new
     * model's history, it enters the first that forms a reachable pair with the device's.
     *
     * @param original a state of the original model
     */
    public Decision.Resynchronization find(Configuration at, State original) {
        return company.find(at, original);
    }

    /** Whether the new model stays where it is if the device is found in its state. */
    public boolean isFollowed(Configuration at) {
        return company.isFollowed(at);
    }

    /** Whether {@code state} is a new one that needs the device in a certain state. */
    public boolean needsDevice(State state) {
        return conversion.needsDevice(state);
    }

    /** Whether the device is where the new model's state needs it: always, unless that state has a device state. */
    public boolean isWhereNeeded(Configuration at) {
        return conversion.isWhereNeeded(at);
    }

    /**
     * Whether the states are a reachable pair: expected events can lead there. In a new state with a device state,
     * whether the device is there.
     */
    public boolean standsTogether(Configuration at) {
        return company.standsTogether(at);
    }

    /**
     * The decision that makes the states of device and evolved system a reachable pair after a takeover from other
     * models: nothing, or a path to a state of the device that is compatible with the new model's; a {@link
     * Decision.Sending} or {@link Decision.Impossible}.
     */
    public synchronized Decision settle(Configuration at) {
        return conversion.settle(at, standsTogether(at) ? List.of(at.original()) : company.of(at.evolved()));
    }

    /**
     * The decision for an event whose plan has failed: a {@link Decision.Impossible} with the way back as its steps,
     * another path, or that there is none.
     *
     * @param usual the decision for the event now, had nothing failed
     */
    public synchronized Decision afterFailure(Decision usual, Configuration at, BrokenPlan broken) {
        return conversion.afterFailure(usual, at, broken);
    }

    /** Every reachable configuration, in the order of exploration. */
    public Set<Configuration> configurations() {
        return Collections.unmodifiableSet(situations.keySet());
    }

    /**
     * Effects of the new model that the converter has to run, in the order in which they are drawn: those that the
     * device does not know, and those that it does not run by itself in some decision.
     */
    public Set<String> effects() {
        Set<String> drawn = new LinkedHashSet<>();
        for (Transition transition : pair.evolved().transitions()) {
            drawn.addAll(transition.effects());
        }
        if (drawn.isEmpty()) {
            return drawn;
        }
        Set<String> missing = new HashSet<>(drawn);
        for (Transition transition : pair.original().transitions()) {
            transition.effects().forEach(missing::remove);
        }
        for (Configuration at : situations.keySet()) {
            expected(at).forEach(turn -> missing.addAll(turn.decision().effects()));
            interference(at).forEach(turn -> missing.addAll(turn.decision().effects()));
        }
        drawn.retainAll(missing);
        return drawn;
    }

    /** The events between converter and device, including the original model's declarations. */
    public DeviceEvents device() {
        return device;
    }

    /** Decisions whose next state the device has but no plan reaches; an evolution must have none. */
    public List<Decision.Impossible> problems() {
        return List.copyOf(problems);
    }

    /**
     * As {@link #problems()}, but only after the device has done by itself what could have been sent to it. Such an
     * event fails, and the system stays where it is.
     */
    public List<Decision.Impossible> hazards() {
        return List.copyOf(hazards);
    }
}
