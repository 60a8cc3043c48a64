package org.evoloop.models;

import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.stream.Collectors;
import org.evoloop.evolution.DeviceEvents;
import org.evoloop.evolution.ModelPair;
import org.evoloop.models.checking.Drawings;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.State;
import org.evoloop.statemachine.StateMachine;
import org.evoloop.xmi.ModelReference;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Spec;

/** The two models of an evolution, and what their author knows of the device. */
@SuppressWarnings("NullAway.Init") // picocli sets the fields
final class PairOptions {
    @Spec(Spec.Target.MIXEE)
    private CommandSpec spec;

    @Mixin
    private PairParameters models;

    @Option(
            names = "--sendable",
            split = ",",
            paramLabel = "EVENT",
            description =
                    "Events that can be sent to the device, with commas between; unless told otherwise all events of"
                            + " the original model but time triggers and those that the device takes of its own accord.")
    private List<String> sendable = List.of();

    @Option(
            names = {"--spontaneous", "--device-only"},
            split = ",",
            paramLabel = "EVENT",
            description =
                    "Events that the device takes of its own accord, such as that it has finished, or those of its"
                            + " buttons; they cannot be sent unless --sendable names them too.")
    private List<String> spontaneous = List.of();

    @Option(
            names = "--cost",
            paramLabel = "EVENT=N",
            description = "Makes ways avoid an event: the way with the least sum is taken (1 unless told otherwise).")
    private Map<String, Integer> costs = Map.of();

    @Option(
            names = "--do-not-pass",
            split = ",",
            paramLabel = "STATE",
            description = "States of the device through which no way may lead.")
    private List<String> doNotPass = List.of();

    ModelReference original() {
        return models.original();
    }

    ModelReference evolved() {
        return models.evolved();
    }

    /** Reads both models. */
    ModelPair read() {
        return models.read(spec);
    }

    /** Where the parts of {@code pair} stand in their files. */
    Drawings drawings(ModelPair pair) {
        return new Drawings(
                ModelReader.drawing(original(), pair.original()), ModelReader.drawing(evolved(), pair.evolved()));
    }

    /** What passes between converter and device. @throws IllegalArgumentException for a name that the model lacks */
    DeviceEvents device(StateMachine device) {
        Set<Event> known = device.triggers();
        Set<Event> own = new LinkedHashSet<>(events("--spontaneous", spontaneous, known));
        Set<Event> sent = new LinkedHashSet<>(events("--sendable", sendable, known));
        if (sendable.isEmpty()) {
            known.stream().filter(event -> event.timeTrigger().isEmpty()).forEach(sent::add);
            sent.removeAll(own);
            sent.removeAll(device.spontaneous());
        }
        Map<Event, Integer> eventCosts = new LinkedHashMap<>();
        costs.forEach(
                (name, cost) -> events("--cost", List.of(name), known).forEach(event -> eventCosts.put(event, cost)));
        Set<State> notPassed =
                KnownNames.resolve("--do-not-pass", doNotPass, KnownNames.states(device), "state of the original model")
                        .stream()
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
