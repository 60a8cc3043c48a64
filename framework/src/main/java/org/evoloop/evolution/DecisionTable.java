package org.evoloop.evolution;

import java.util.ArrayDeque;
import java.util.Collections;
import java.util.HashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Queue;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.State;
import org.jspecify.annotations.Nullable;

/**
 * The transition hash table: the decision for every event in every configuration that can be reached, made once, so
 * that deciding at run time is a look-up.
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
    private final Map<Configuration, Row> rows = new ConcurrentHashMap<>();
    private final Set<Configuration> reachable = new LinkedHashSet<>();
    private final Set<Decision.Impossible> problems = new LinkedHashSet<>();
    private final Set<Decision.Impossible> hazards = new LinkedHashSet<>();

    /** The decisions of one configuration, by event: asked for, or already acted on by the device. */
    private record Row(Map<Event, Decision> asked, Map<Event, Decision> acted) {}

    private DecisionTable(ModelPair pair, DeviceEvents device) {
        this.pair = pair;
        this.conversion = new EventConversion(pair, device);
    }

    /**
     * Explores every configuration that can be reached from the initial one.
     *
     * @param pair a valid pair, see {@link ModelPair#requireValid()}
     */
    public static DecisionTable compile(ModelPair pair, DeviceEvents device) {
        DecisionTable table = new DecisionTable(pair, device);
        table.explore(new ArrayDeque<>(List.of(pair.initial())), device, false, table.problems);
        Queue<Configuration> interfered = new ArrayDeque<>();
        for (Configuration at : table.reachable) {
            table.followInterference(at, device, table.hazards, interfered);
        }
        table.explore(interfered, device, true, table.hazards);
        return table;
    }

    private void explore(
            Queue<Configuration> frontier,
            DeviceEvents device,
            boolean interference,
            Set<Decision.Impossible> impossible) {
        for (Configuration at = frontier.poll(); at != null; at = frontier.poll()) {
            if (reachable.add(at)) {
                Row row = row(at);
                for (Event event : pair.evolved().events()) {
                    follow(row.asked().get(event), impossible, frontier);
                }
                if (interference) {
                    followInterference(at, device, impossible, frontier);
                }
            }
        }
    }

    private void followInterference(
            Configuration at, DeviceEvents device, Set<Decision.Impossible> impossible, Queue<Configuration> frontier) {
        for (Event event : device.spontaneous()) {
            if (pair.original().hasTransition(at.original(), event)) {
                follow(row(at).acted().get(event), impossible, frontier);
            }
        }
    }

    private static void follow(
            @Nullable Decision decision, Set<Decision.Impossible> impossible, Queue<Configuration> frontier) {
        if (decision instanceof Decision.Impossible found) {
            impossible.add(found);
        } else if (decision != null) {
            frontier.add(decision.after());
        }
    }

    private Row row(Configuration at) {
        Row known = rows.get(at);
        return known != null ? known : rows.computeIfAbsent(at, this::decideAll);
    }

    /** The conversion remembers its searches, which is not thread-safe. */
    private synchronized Row decideAll(Configuration at) {
        Row row = new Row(new HashMap<>(), new HashMap<>());
        for (Event event : pair.evolved().events()) {
            row.asked().put(event, conversion.decide(at, event, false));
            row.acted().put(event, conversion.decide(at, event, true));
        }
        return row;
    }

    /**
     * What {@code event} means in {@code at}.
     *
     * @param deviceActed whether the device has already acted on it
     * @return {@link Decision.NotAcceptable} without steps for an event that neither model knows
     */
    public Decision decide(Configuration at, Event event, boolean deviceActed) {
        Row row = row(at);
        Decision decision = (deviceActed ? row.acted() : row.asked()).get(event);
        return decision == null ? new Decision.NotAcceptable(at, at, List.of()) : decision;
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
                at, reachable.contains(kept) ? kept : new Configuration(original, original));
    }

    /** Every configuration that can be reached, first reached first. */
    public Set<Configuration> configurations() {
        return Collections.unmodifiableSet(reachable);
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
