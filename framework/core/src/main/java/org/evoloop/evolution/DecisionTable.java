package org.evoloop.evolution;

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
 * The transition hash table: the decision for every event in every configuration that can be reached, made once, so
 * that deciding at run time is a look-up. Situations and events have numbers, which make it a quick one.
 *
 * <p>Reached means by events as they should go: asked for by a controller, a timer or a function, or taken by the device
 * where its model says that it can. What the device may do although it could have been asked, such as act on its own
 * buttons, is explored last, so that a decision that cannot be carried out is known to be a {@linkplain #problems()
 * problem} of the models or a {@linkplain #hazards() hazard} of such interference. Where a plan broke off between two
 * steps the system stands elsewhere; decisions there are made by the same function when they are first needed.
 *
 * <p>Threading: thread-safe.
 *
 * @since 0.1
 */
public final class DecisionTable {
    private final ModelPair pair;
    private final DeviceEvents device;
    private final EventNames names;
    /** Whether the device takes any event by itself that could be sent. */
    private final boolean interferes;

    private final EventConversion conversion;
    private final GuardedTriggers originalGuards;
    private final GuardedTriggers evolvedGuards;
    /** In the order in which they were reached, which is that of their numbers. */
    private final Map<Configuration, Integer> situations = new LinkedHashMap<>();
    /** The same by their numbers, those that are still to be explored included. */
    private final List<Configuration> reached = new ArrayList<>();

    private int explored;

    /** How many were reached by events as they should go. */
    private int expected;

    private final Map<Event, Integer> numbers = new HashMap<>();
    private final Map<String, Integer> numbersByName = new HashMap<>();
    private final DecisionCells asked;
    private final DecisionCells acted;
    private final List<Decision> ignored = new ArrayList<>();
    private final Set<Decision.Impossible> problems = new LinkedHashSet<>();
    private final Set<Decision.Impossible> hazards = new LinkedHashSet<>();

    private DecisionTable(ModelPair pair, DeviceEvents device) {
        this.pair = pair;
        this.device = device.declaredBy(pair.original());
        this.interferes = this.device.spontaneous().stream().anyMatch(this.device.sendable()::contains);
        this.conversion = new EventConversion(pair, this.device);
        this.names = EventNames.of(pair);
        this.originalGuards = new GuardedTriggers(pair.original());
        this.evolvedGuards = new GuardedTriggers(pair.evolved());
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
     * Explores every configuration that can be reached from the initial one.
     *
     * @param pair a valid pair, see {@link ModelPair#requireValid()}
     */
    public static DecisionTable compile(ModelPair pair, DeviceEvents device) {
        DecisionTable table = new DecisionTable(pair, device);
        table.reach(pair.initial());
        table.explore(false, table.problems);
        table.expected = table.reached.size();
        for (int situation = 0; situation < table.expected; situation++) {
            table.follow(situation, table.interference(table.reached.get(situation), situation), table.hazards);
        }
        table.explore(true, table.hazards);
        table.asked.link(decision -> table.situation(decision.after()));
        return table;
    }

    /** The number of a configuration, which is to be explored if it was not reached before. */
    private int reach(Configuration at) {
        Integer known = situations.putIfAbsent(at, reached.size());
        if (known != null) {
            return known;
        }
        reached.add(at);
        return reached.size() - 1;
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

    private void follow(int situation, List<Turn> turns, Set<Decision.Impossible> impossible) {
        for (Turn turn : turns) {
            if (turn.decision() instanceof Decision.Impossible found) {
                // An event that cannot come is one problem of its own, not one in each configuration.
                if (!conversion.isUnsendable(turn.event().trigger())) {
                    impossible.add(found);
                }
            } else {
                int next = reach(turn.decision().after());
                if (!turn.deviceActed()) {
                    asked.lead(situation, number(turn.event()), next);
                }
            }
        }
    }

    /** What can happen in {@code at} as it should: events that the new model accepts, and what the device does by itself. */
    public List<Turn> expected(Configuration at) {
        return expected(at, situation(at));
    }

    private List<Turn> expected(Configuration at, int situation) {
        List<Turn> turns = new ArrayList<>();
        for (Transition transition : pair.evolved().transitionsFrom(at.evolved())) {
            if (evolvedGuards.shadowOf(transition) == null) {
                turns.add(turn(at, situation, transition.event(), false));
            }
        }
        for (Transition transition : pair.original().transitionsFrom(at.original())) {
            if (device.isOwn(transition.event().trigger()) && isUnheard(at, transition)) {
                turns.add(turn(at, situation, transition.event(), false));
            }
        }
        return turns;
    }

    /** What can happen in {@code at} when the device does by itself what it could have been asked for. */
    public List<Turn> interference(Configuration at) {
        return interference(at, situation(at));
    }

    private List<Turn> interference(Configuration at, int situation) {
        if (!interferes) {
            return List.of();
        }
        List<Turn> turns = new ArrayList<>();
        for (Transition transition : pair.evolved().transitionsFrom(at.evolved())) {
            if (isSpontaneous(transition)
                    && evolvedGuards.shadowOf(transition) == null
                    && conversion.originalTransition(at.original(), transition.event()) != null) {
                turns.add(turn(at, situation, transition.event(), true));
            }
        }
        for (Transition transition : pair.original().transitionsFrom(at.original())) {
            if (isSpontaneous(transition) && isUnheard(at, transition)) {
                turns.add(turn(at, situation, transition.event(), true));
            }
        }
        return turns;
    }

    private boolean isSpontaneous(Transition transition) {
        Event trigger = transition.event().trigger();
        return device.spontaneous().contains(trigger) && device.sendable().contains(trigger);
    }

    /** Whether the device may take {@code transition} with the new model not accepting its event. */
    private boolean isUnheard(Configuration at, Transition transition) {
        return originalGuards.shadowOf(transition) == null
                && !pair.evolved().hasTransition(at.evolved(), transition.event())
                && !pair.evolved()
                        .hasTransition(at.evolved(), transition.event().trigger());
    }

    private Turn turn(Configuration at, int situation, Event event, boolean deviceActed) {
        return new Turn(event, deviceActed, decide(at, situation, event, deviceActed));
    }

    /** Decides all that either model knows in {@code at}; whatever else comes there is ignored. */
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

    /** @param transition of the new model; null if it has none */
    private void fill(Configuration at, int situation, Event event, @Nullable Transition transition) {
        int number = number(event);
        if (asked.get(situation, number) == null) {
            Transition same = conversion.originalTransition(at.original(), event);
            asked.put(situation, number, conversion.decide(at, event, false, transition, same));
            // If the device is not said to act by itself, what its doing so means is decided when that happens.
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

    /** The number of the initial situation, for the quick methods. */
    public int initial() {
        return 0;
    }

    /** The number of a configuration, for the quick methods; {@code -1} if it is not one of {@link #configurations}. */
    public int situation(Configuration at) {
        Integer known = situations.get(at);
        return known == null ? DecisionCells.UNKNOWN : known;
    }

    /** The number of an event, for the quick methods; {@code -1} for one that neither model knows. */
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
     * What an event that was asked for means; nothing is allocated, and nothing is hashed.
     *
     * @param situation a {@linkplain #situation number} other than {@code -1}
     * @param event a {@linkplain #number(Event) number}; {@code -1} is not acceptable anywhere
     */
    public Decision decide(int situation, int event) {
        Decision decision = event < 0 ? null : asked.get(situation, event);
        return decision == null ? ignored.get(situation) : decision;
    }

    /** The same by the event's name. */
    public Decision decide(int situation, String event) {
        return decide(situation, number(event));
    }

    /** The situation in which {@link #decide(int, int)} ends; {@code -1} if it is not one of {@link #configurations}. */
    public int after(int situation, int event) {
        return event < 0 ? situation : asked.after(situation, event);
    }

    /** The same by the event's name. */
    public int after(int situation, String event) {
        return after(situation, number(event));
    }

    /**
     * What {@code event} means in {@code at}.
     *
     * @param event with the guards under which it comes, see {@link #resolve}
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
     * What {@code event} means to the new model after the device has acted on it, and maybe gone on from there: a plan
     * begins where the device is now, in {@code at}.
     *
     * @param event with the guards under which it comes, see {@link #resolve}
     * @param own the step that the device took; null if its model has none
     * @param follow whether the new model only has to follow, without anything being sent, where both models agree on what
     *     the device did
     */
    public synchronized Decision react(Configuration at, Event event, @Nullable Step own, boolean follow) {
        return conversion.react(at, event, own, follow);
    }

    /** What it takes to have the device do {@code trigger}, which a new function asks for. */
    public Decision ask(Configuration at, Event trigger, Predicate<String> holds) {
        Event event = originalGuards.resolve(at.original(), trigger, holds);
        Transition taken = event == null ? null : conversion.originalTransition(at.original(), event);
        if (taken == null || !device.sendable().contains(trigger)) {
            String why =
                    taken == null ? "the device has no transition for it in " + at.original() : "nobody can send it";
            return new Decision.Impossible(at, at, List.of(), null, "a function asks for " + trigger + ", but " + why);
        }
        boolean conditional = !originalGuards.conditionsOf(taken).isEmpty();
        return new Decision.Sending(at, at.withOriginal(taken.target()), List.of(new Step(taken, false, conditional)));
    }

    /** Whether only the device itself can take {@code trigger}. */
    public boolean isDevicesOwn(Event trigger) {
        return device.isOwn(trigger);
    }

    /** Whether {@code state} is one that only the new model has: a function that the converter runs. */
    public boolean isNew(State state) {
        return conversion.isNew(state);
    }

    /**
     * The step that the device takes by itself on {@code trigger} in {@code at}; null if its model has none there.
     *
     * @param holds whether the condition of this text holds now; false for one that cannot be asked
     */
    public @Nullable Step ownStep(State at, Event trigger, Predicate<String> holds) {
        Event event = originalGuards.resolve(at, trigger, holds);
        Transition taken = event == null ? null : conversion.originalTransition(at, event);
        return taken == null ? null : new Step(taken, true, false);
    }

    /**
     * Under which guards {@code trigger} comes: those of the new model, else, when the device may have taken it by itself,
     * those of the original.
     *
     * @param trigger an event without guards, as a monitor reports it
     * @param holds whether the condition of this text holds now; false for one that cannot be asked
     * @return what to {@link #decide} on; {@code trigger} itself where no guard is drawn for it
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
     * Whether {@code event} is to wait, if it comes in {@code at}, until a state of the new model that does not defer it
     * (UML 2.5.1, clause 14.2.3.4.4); it is then not to be decided. What the device has done already waits for nothing.
     *
     * @param event as {@link #resolve} gives it
     */
    public boolean defers(Configuration at, Event event) {
        return pair.evolved().defers(at.evolved(), event);
    }

    /** Whether {@code step} is where its trigger leads now. */
    public boolean isOpen(Step step, Predicate<String> holds) {
        return !step.conditional() || step.event().equals(originalGuards.resolve(step.source(), step.trigger(), holds));
    }

    /**
     * What it means that the device was found in {@code original}: the new model stays where it is if the two can stand
     * together, that is if events as they should go can lead there; else it follows the device. Of several states that
     * differ in what the new model remembers it goes to the first that can stand together with the device's.
     *
     * @param original a state of the original model
     */
    public Decision.Resynchronization find(Configuration at, State original) {
        Configuration kept = at.withOriginal(original);
        return new Decision.Resynchronization(at, situations.containsKey(kept) ? kept : followed(original));
    }

    private Configuration followed(State original) {
        List<State> same = pair.evolvedStates(original);
        for (State state : same) {
            Configuration together = new Configuration(original, state);
            if (situations.containsKey(together)) {
                return together;
            }
        }
        return new Configuration(original, same.isEmpty() ? original : same.get(0));
    }

    /** Whether events as they should go can lead there. */
    public boolean standsTogether(Configuration at) {
        int situation = situation(at);
        return situation >= 0 && situation < expected;
    }

    /**
     * What it takes that device and evolved system stand together, where another pair of models has led: nothing, or a way to
     * a state of the device in which the new model's may be; a {@link Decision.Sending} or {@link Decision.Impossible}.
     */
    public synchronized Decision settle(Configuration at) {
        return conversion.settle(at, standsTogether(at) ? List.of(at.original()) : companions(at.evolved()));
    }

    /**
     * What is to be done for an event whose plan has broken off: a {@link Decision.Impossible} with the way back as its
     * steps; another way, or that there is none.
     *
     * @param usual what the event means now, had nothing failed
     */
    public synchronized Decision afterFailure(Decision usual, Configuration at, BrokenPlan broken) {
        return conversion.afterFailure(usual, at, broken);
    }

    /** The states of the device in which {@code evolved} may be: those that it is, or for a new one all that go with it. */
    private List<State> companions(State evolved) {
        List<State> same = pair.deviceStates(evolved);
        return !same.isEmpty()
                ? same
                : reached.subList(0, expected).stream()
                        .filter(at -> at.evolved().equals(evolved))
                        .map(Configuration::original)
                        .toList();
    }

    /** Every configuration that can be reached, first reached first. */
    public Set<Configuration> configurations() {
        return Collections.unmodifiableSet(situations.keySet());
    }

    /**
     * Effects of the new model that the converter has to see to, in the order in which they are drawn: those that the device
     * does not know, and those that it does not do by itself on the way of some decision.
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
            List<Turn> turns = expected(at);
            turns.addAll(interference(at));
            for (Turn turn : turns) {
                missing.addAll(turn.decision().effects());
            }
        }
        drawn.retainAll(missing);
        return drawn;
    }

    /** What passes between converter and device, with what the original model declares. */
    public DeviceEvents device() {
        return device;
    }

    /** Decisions that lead to a state of the device to which no plan leads; an evolution must have none. */
    public List<Decision.Impossible> problems() {
        return List.copyOf(problems);
    }

    /**
     * The same, but only after the device has done by itself what it could have been asked for. Such an event fails, and
     * the system stays where it is.
     */
    public List<Decision.Impossible> hazards() {
        return List.copyOf(hazards);
    }
}
