package org.evoloop.evolution;

import java.util.List;
import java.util.Map;
import org.evoloop.statemachine.State;

/**
 * Which states of device and new model go together, and where the new model goes if they do not.
 *
 * <p>Threading: thread-safe once all configurations are known.
 */
final class Company {
    private final ModelPair pair;
    private final EventConversion conversion;
    /** Every reachable configuration with its number. */
    private final Map<Configuration, Integer> situations;
    /** The same, in order. */
    private final List<Configuration> reached;

    /** How many were reached by expected events. */
    private int expected;

    Company(
            ModelPair pair,
            EventConversion conversion,
            Map<Configuration, Integer> situations,
            List<Configuration> reached) {
        this.pair = pair;
        this.conversion = conversion;
        this.situations = situations;
        this.reached = reached;
    }

    /** The first {@code count} configurations are those that expected events reach. */
    void reachesByExpectedEvents(int count) {
        expected = count;
    }

    /** See {@link DecisionTable#find}. */
    Decision.Resynchronization find(Configuration at, State original) {
        Configuration kept = at.withOriginal(original);
        boolean asks = original.equals(at.original()) || conversion.needsDevice(at.evolved());
        boolean stays = asks ? isFollowed(kept) : situations.containsKey(kept);
        return new Decision.Resynchronization(at, stays ? kept : followed(original));
    }

    /** See {@link DecisionTable#isFollowed}. */
    boolean isFollowed(Configuration at) {
        if (conversion.needsDevice(at.evolved())) {
            return conversion.isWhereNeeded(at);
        }
        return situations.containsKey(at)
                || pair.deviceStates(at.evolved()).contains(at.original())
                || followed(at.original()).equals(at);
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

    /** See {@link DecisionTable#standsTogether}. */
    boolean standsTogether(Configuration at) {
        if (conversion.needsDevice(at.evolved())) {
            return conversion.isWhereNeeded(at);
        }
        Integer situation = situations.get(at);
        return situation != null && situation < expected;
    }

    /** The device's states for {@code evolved}: where it must be, or if that is anywhere, all that are reachable with it. */
    List<State> of(State evolved) {
        List<State> same = pair.whereDeviceMustBe(evolved);
        return !same.isEmpty()
                ? same
                : reached.subList(0, expected).stream()
                        .filter(at -> at.evolved().equals(evolved))
                        .map(Configuration::original)
                        .toList();
    }
}
