package org.evoloop.evolution;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Collections;
import java.util.HashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Queue;
import java.util.Set;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.State;
import org.evoloop.statemachine.Transition;

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
 */
public final class DecisionTable {
    private final ModelPair pair;
    private final EventConversion conversion;
    private final Map<Configuration, Integer> situations = new HashMap<>();
    private final List<Configuration> configurations = new ArrayList<>();
    private final Map<Event, Integer> events = new HashMap<>();
    private final Map<String, Integer> eventNames = new HashMap<>();
    private final Decision.NotAcceptable[] unchanged;
    private final DecisionCells asked;
    private final DecisionCells acted;
    private final Set<Decision.Impossible> problems = new LinkedHashSet<>();
    private final Set<Decision.Impossible> hazards = new LinkedHashSet<>();

    private DecisionTable(ModelPair pair, DeviceEvents device) {
        this.pair = pair;
        this.conversion = new EventConversion(pair, device);
        for (Event event : pair.evolved().events()) {
            eventNames.putIfAbsent(event.toString(), events.size());
            events.put(event, events.size());
        }
        asked = new DecisionCells(events.size());
        acted = new DecisionCells(events.size());
        explore(new ArrayDeque<>(List.of(pair.initial())), device, false, problems);
        Queue<Configuration> interfered = new ArrayDeque<>();
        for (Configuration at : List.copyOf(configurations)) {
            followInterference(at, device, hazards, interfered);
        }
        explore(interfered, device, true, hazards);
        unchanged = configurations.stream()
                .map(at -> new Decision.NotAcceptable(at, at, List.of()))
                .toArray(Decision.NotAcceptable[]::new);
        asked.link(decision -> situation(decision.after()));
    }

    /**
     * Explores every configuration that can be reached from the initial one.
     *
     * @param pair a valid pair, see {@link ModelPair#requireValid()}
     */
    public static DecisionTable compile(ModelPair pair, DeviceEvents device) {
        return new DecisionTable(pair, device);
    }

    private void explore(
            Queue<Configuration> frontier,
            DeviceEvents device,
            boolean interference,
            Set<Decision.Impossible> impossible) {
        for (Configuration at = frontier.poll(); at != null; at = frontier.poll()) {
            if (situations.putIfAbsent(at, configurations.size()) == null) {
                int situation = configurations.size();
                configurations.add(at);
                for (Transition transition : pair.evolved().transitionsFrom(at.evolved())) {
                    Decision decision = conversion.decide(at, transition.event(), false);
                    asked.put(situation, number(transition.event()), decision);
                    follow(decision, impossible, frontier);
                }
                decideWhatTheDeviceTakes(at, situation, impossible, frontier);
                if (interference) {
                    followInterference(at, device, impossible, frontier);
                }
            }
        }
    }

    /** Only where the device itself has a transition does it matter whether it has acted already. */
    private void decideWhatTheDeviceTakes(
            Configuration at, int situation, Set<Decision.Impossible> impossible, Queue<Configuration> frontier) {
        for (Transition transition : pair.original().transitionsFrom(at.original())) {
            int event = number(transition.event());
            if (event < 0) {
                continue;
            }
            acted.put(situation, event, conversion.decide(at, transition.event(), true));
            if (asked.get(situation, event) == null) {
                Decision decision = conversion.decide(at, transition.event(), false);
                asked.put(situation, event, decision);
                follow(decision, impossible, frontier);
            }
        }
    }

    private void followInterference(
            Configuration at, DeviceEvents device, Set<Decision.Impossible> impossible, Queue<Configuration> frontier) {
        for (Event event : device.spontaneous()) {
            if (pair.original().hasTransition(at.original(), event)) {
                follow(decide(at, event, true), impossible, frontier);
            }
        }
    }

    private static void follow(Decision decision, Set<Decision.Impossible> impossible, Queue<Configuration> frontier) {
        if (decision instanceof Decision.Impossible found) {
            impossible.add(found);
        } else {
            frontier.add(decision.after());
        }
    }

    /** The number of the initial situation. */
    public int initial() {
        return 0;
    }

    /** The number of a configuration, for the quick methods; {@code -1} if it is not one of {@link #configurations}. */
    public int situation(Configuration at) {
        Integer known = situations.get(at);
        return known == null ? DecisionCells.UNKNOWN : known;
    }

    /** The number of an event, for the quick methods; {@code -1} for one that the new model does not know. */
    public int number(Event event) {
        Integer known = events.get(event);
        return known == null ? -1 : known;
    }

    /** The number of the event of this name, as {@link Event#toString} writes it; {@code -1} if there is none. */
    public int number(String event) {
        Integer known = eventNames.get(event);
        return known == null ? -1 : known;
    }

    /**
     * What an event that was asked for means; by numbers, nothing is allocated.
     *
     * @param situation a {@linkplain #situation number}, not {@code -1}
     * @param event a {@linkplain #number(Event) number}; {@code -1} is not acceptable anywhere
     */
    public Decision decide(int situation, int event) {
        Decision decision = event < 0 ? null : asked.get(situation, event);
        return decision == null ? unchanged[situation] : decision;
    }

    /** The same by the event's name. */
    public Decision decide(int situation, String event) {
        return decide(situation, number(event));
    }

    /** The situation in which {@link #decide(int, int)} ends; {@code -1} if it is not one of {@link #configurations}. */
    public int after(int situation, int event) {
        return event < 0 || asked.get(situation, event) == null ? situation : asked.after(situation, event);
    }

    /** The same by the event's name. */
    public int after(int situation, String event) {
        return after(situation, number(event));
    }

    /**
     * What {@code event} means in {@code at}.
     *
     * @param deviceActed whether the device has already acted on it
     * @return {@link Decision.NotAcceptable} without steps for an event that neither model knows
     */
    public Decision decide(Configuration at, Event event, boolean deviceActed) {
        int number = number(event);
        if (number < 0) {
            return new Decision.NotAcceptable(at, at, List.of());
        }
        int situation = situation(at);
        if (situation == DecisionCells.UNKNOWN) {
            return decideNow(at, event, deviceActed);
        }
        Decision own = deviceActed ? acted.get(situation, number) : null;
        return own != null ? own : decide(situation, number);
    }

    /** The conversion remembers its searches, which is not thread-safe. */
    private synchronized Decision decideNow(Configuration at, Event event, boolean deviceActed) {
        return conversion.decide(at, event, deviceActed);
    }

    /**
     * What it means that the device was found in {@code original}: the new model stays where it is if the two can stand
     * together, that is if events as they should go can lead there; else it follows the device.
     *
     * @param original a state of the original model
     */
    public Decision.Resynchronization find(Configuration at, State original) {
        Configuration kept = at.withOriginal(original);
        return new Decision.Resynchronization(
                at, situations.containsKey(kept) ? kept : new Configuration(original, original));
    }

    /** Every configuration that can be reached, first reached first. */
    public Set<Configuration> configurations() {
        return Collections.unmodifiableSet(new LinkedHashSet<>(configurations));
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
