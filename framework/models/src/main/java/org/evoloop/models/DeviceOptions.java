package org.evoloop.models;

import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.stream.Collectors;
import org.evoloop.evolution.DeviceEvents;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.State;
import org.evoloop.statemachine.StateMachine;
import picocli.CommandLine.Option;

/** Options for what the author knows about the device. */
@SuppressWarnings("NullAway.Init") // picocli sets the fields
final class DeviceOptions {
    @Option(
            names = "--sendable",
            split = ",",
            paramLabel = "EVENT",
            description =
                    "Events that can be sent to the device, separated by commas (default: all events of the original"
                            + " model except time triggers and those that the device takes by itself).")
    private List<String> sendable = List.of();

    @Option(
            names = {"--spontaneous", "--device-only"},
            split = ",",
            paramLabel = "EVENT",
            description =
                    "Events that the device takes by itself, for example when it has finished or when its own buttons"
                            + " are pressed; they cannot be sent unless --sendable lists them as well.")
    private List<String> spontaneous = List.of();

    @Option(
            names = "--cost",
            paramLabel = "EVENT=N",
            description = "Cost of sending EVENT (default 1); plans minimise the total cost.")
    private Map<String, Integer> costs = Map.of();

    @Option(
            names = "--do-not-pass",
            split = ",",
            paramLabel = "STATE",
            description = "States of the device that no path may pass through.")
    private List<String> doNotPass = List.of();

    /**
     * The events between converter and device.
     *
     * @throws IllegalArgumentException for a name that the model lacks
     */
    DeviceEvents of(StateMachine device) {
        return of(device, device);
    }

    /**
     * The events between converter and device. Names that only the device's other model has are accepted and ignored.
     *
     * @throws IllegalArgumentException for a name that neither model has
     */
    DeviceEvents of(StateMachine device, StateMachine other) {
        Set<Event> known = new LinkedHashSet<>(device.triggers());
        known.addAll(other.triggers());
        Set<Event> own = new LinkedHashSet<>(events("--spontaneous", spontaneous, known));
        Set<Event> sent = new LinkedHashSet<>(events("--sendable", sendable, known));
        if (sendable.isEmpty()) {
            sent.addAll(DeviceEvents.assumedOf(device).sendable());
            sent.removeAll(own);
        }
        Map<Event, Integer> eventCosts = new LinkedHashMap<>();
        costs.forEach(
                (name, cost) -> events("--cost", List.of(name), known).forEach(event -> eventCosts.put(event, cost)));
        Set<String> states = KnownNames.states(device);
        states.addAll(KnownNames.states(other));
        Set<State> notPassed =
                KnownNames.resolve("--do-not-pass", doNotPass, states, "state of the original model").stream()
                        .map(State::new)
                        .collect(Collectors.toSet());
        return new DeviceEvents(sent, own)
                .withCosts(eventCosts)
                .withDoNotPass(notPassed)
                .withBoundGuards(device.guards());
    }

    private static List<Event> events(String option, List<String> names, Set<Event> known) {
        List<String> there = known.stream().map(Event::name).toList();
        return KnownNames.resolve(option, names, there, "event of the original model").stream()
                .map(Event::new)
                .toList();
    }
}
