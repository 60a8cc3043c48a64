package org.evoloop.journal;

import java.time.Duration;
import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Set;
import org.evoloop.core.Rules;
import org.evoloop.evolution.Configuration;
import org.evoloop.evolution.DecisionTable;
import org.evoloop.evolution.DeviceEvents;
import org.evoloop.evolution.ModelPair;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.State;

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
        DecisionTable table = DecisionTable.compile(models, device(head.device(), head.models()));
        Map<State, Map<Event, Duration>> timers = new HashMap<>();
        models.evolved().states().forEach(state -> timers.put(state, timers(state, head)));
        return new Rules(table, state -> timers.getOrDefault(state, Map.of()), head.queueCapacity(), head.pressAge());
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

    /** The states in which the other models begin if the recorded ones were in {@code then}. */
    Configuration placed(Configuration then) {
        State device = models.original().hasState(then.original())
                ? then.original()
                : models.original().initial();
        if (models.evolved().hasState(then.evolved())) {
            return new Configuration(device, then.evolved());
        }
        return new Configuration(device, models.evolvedStates(device).get(0));
    }
}
