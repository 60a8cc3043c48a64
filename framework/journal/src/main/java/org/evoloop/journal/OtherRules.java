package org.evoloop.journal;

import java.time.Duration;
import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.evoloop.engine.Rules;
import org.evoloop.engine.Snapshot;
import org.evoloop.engine.Tally;
import org.evoloop.evolution.Configuration;
import org.evoloop.evolution.DecisionTable;
import org.evoloop.evolution.DeviceEvents;
import org.evoloop.evolution.ModelPair;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.State;
import org.evoloop.statemachine.StateMachine;

/**
 * Other models under the conditions of a recorded converter: the events that can be sent, timers, and how many
 * presses may wait, and how long.
 */
final class OtherRules {
    private final ModelPair models;

    OtherRules(ModelPair models) {
        this.models = models;
    }

    Rules like(Head head) {
        DecisionTable table = DecisionTable.compile(withSends(head.models()), device(head.device(), head.models()));
        Map<State, Map<Event, Duration>> timers = new HashMap<>();
        models.evolved().states().forEach(state -> timers.put(state, timers(state, head)));
        return new Rules(table, state -> timers.getOrDefault(state, Map.of()), head.queueCapacity(), head.pressAge());
    }

    /** The models with what functions send by code, too: it was registered for a state of the same name. */
    private ModelPair withSends(ModelPair recorded) {
        StateMachine evolved = models.evolved();
        for (State state : evolved.states()) {
            if (models.isNew(state) && recorded.evolved().hasState(state)) {
                for (Event event : recorded.evolved().sends(state)) {
                    if (models.original().triggers().contains(event)) {
                        evolved = evolved.withSends(state, event);
                    }
                }
            }
        }
        return new ModelPair(models.original(), evolved);
    }

    /** Events that only the other device knows can be sent, unless they are the device's own. */
    private DeviceEvents device(DeviceEvents then, ModelPair recorded) {
        Set<Event> triggers = models.original().triggers();
        Set<Event> sendable = new HashSet<>(triggers);
        sendable.removeIf(event -> recorded.original().triggers().contains(event)
                ? !then.sendable().contains(event)
                : event.timeTrigger().isPresent()
                        || models.original().spontaneous().contains(event));
        Set<Event> spontaneous = new HashSet<>(then.spontaneous());
        spontaneous.retainAll(triggers);
        return new DeviceEvents(sendable, spontaneous)
                .withCosts(then.costs())
                .withDoNotPass(then.doNotPass())
                .withOnFailure(then.onFailure())
                .withBoundGuards(models.original().guards());
    }

    /** The drawn timers, and those that code had registered for a state of the same name. */
    private Map<Event, Duration> timers(State state, Head head) {
        Map<Event, Duration> timers = new LinkedHashMap<>();
        head.timers().getOrDefault(state, Map.of()).forEach((event, delay) -> {
            if (event.timeTrigger().isEmpty() && models.evolved().hasTrigger(state, event)) {
                timers.put(event, delay);
            }
        });
        timers.putAll(models.evolved().timers(state));
        return timers;
    }

    /** Where the other models begin if they have no state for where the converter is: nothing waits, and no timer runs. */
    Snapshot placed(Snapshot then) {
        State device = models.original().hasState(then.at().original())
                ? then.at().original()
                : models.original().initial();
        State system = models.evolved().hasState(then.at().evolved())
                ? then.at().evolved()
                : models.evolvedStates(device).get(0);
        List<State> needed = models.whereDeviceMustBe(system);
        boolean elsewhere = models.isNew(system) && !needed.isEmpty() && !needed.contains(device);
        return new Snapshot(
                then.open(),
                new Configuration(
                        device, elsewhere ? models.evolvedStates(device).get(0) : system),
                null,
                0,
                then.nowNanos(),
                new Snapshot.OpenVisit(0, true, null, Map.of(), false),
                List.of(),
                false,
                false,
                null,
                new Tally(0, 0, 0, 0, 0, 0, 0, 0, 0),
                then.nowNanos());
    }
}
