package org.evoloop.journal;

import java.time.Duration;
import java.time.Instant;
import java.util.Collection;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.stream.Collectors;
import org.evoloop.engine.Rules;
import org.evoloop.engine.codec.ByteItems;
import org.evoloop.engine.codec.ByteWriter;
import org.evoloop.evolution.DecisionTable;
import org.evoloop.evolution.DeviceEvents;
import org.evoloop.evolution.ModelPair;
import org.evoloop.evolution.OnFailure;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.State;
import org.evoloop.statemachine.StateMachine;

/**
 * The first record of a segment: the rules by which it was written, and the time.
 *
 * @param fingerprint the fingerprint of the models, see {@link Fingerprint}
 * @param built the fingerprint of the models with which the converter was built, and from which it may have evolved
 * @param models both models
 * @param boot the boot of the computer in which it was written; empty if unknown
 * @param wallNanos the time of day when the segment began, in nanoseconds since 1970
 * @param nowNanos the converter's monotonic clock at that moment
 * @param device the events between converter and device
 * @param timers the timers of the states that have any
 * @param queueCapacity see {@link Rules}
 * @param pressAge see {@link Rules}
 */
record Head(
        String fingerprint,
        String built,
        ModelPair models,
        String boot,
        long wallNanos,
        long nowNanos,
        DeviceEvents device,
        Map<State, Map<Event, Duration>> timers,
        int queueCapacity,
        Duration pressAge) {

    /** @param built the fingerprint of the models with which the converter was built */
    static Head of(String fingerprint, String built, Rules rules, long wallNanos, long nowNanos) {
        ModelPair models = rules.table().models();
        Map<State, Map<Event, Duration>> timers = new TreeMap<>();
        for (State state : models.evolved().states()) {
            Map<Event, Duration> ofState = rules.timers().of(state);
            if (!ofState.isEmpty()) {
                timers.put(state, ofState);
            }
        }
        return new Head(
                fingerprint,
                built,
                models,
                Boot.ID,
                wallNanos,
                nowNanos,
                rules.table().device(),
                timers,
                rules.queueCapacity(),
                rules.pressAge());
    }

    /** Whether {@code other} has the same rules. */
    boolean hasRulesOf(Head other) {
        return fingerprint.equals(other.fingerprint)
                && device.equals(other.device)
                && timers.equals(other.timers)
                && queueCapacity == other.queueCapacity
                && pressAge.equals(other.pressAge);
    }

    /**
     * The rules by which the segment was written; starts with the decisions of {@code present} if its models have this
     * fingerprint.
     */
    Rules rules(Rules present, String presentFingerprint) {
        if (!fingerprint.equals(presentFingerprint)) {
            return rules();
        }
        DecisionTable table = present.table();
        if (!device.equals(table.device())) {
            table = DecisionTable.compile(table.models(), device);
        }
        return new Rules(table, state -> timers.getOrDefault(state, Map.of()), queueCapacity, pressAge);
    }

    /** The rules by which the segment was written, with the models that it contains. */
    Rules rules() {
        DecisionTable table = DecisionTable.compile(models, device);
        return new Rules(table, state -> timers.getOrDefault(state, Map.of()), queueCapacity, pressAge);
    }

    /** The time of day when the converter's monotonic clock showed {@code nanos}. */
    Instant wallTime(long nanos) {
        return Instant.ofEpochSecond(0, wallNanos + nanos - nowNanos);
    }

    void write(ByteWriter bytes) {
        bytes.clear();
        bytes.text(fingerprint);
        bytes.text(built);
        MachineBytes.write(bytes, models.original());
        MachineBytes.write(bytes, models.evolved());
        bytes.text(boot);
        bytes.number(wallNanos);
        bytes.number(nowNanos);
        events(bytes, device.sendable());
        events(bytes, device.spontaneous());
        bytes.number(device.costs().size());
        new TreeMap<>(device.costs()).forEach((event, cost) -> {
            bytes.text(event.name());
            bytes.number(cost);
        });
        texts(bytes, device.doNotPass().stream().map(State::name).toList());
        texts(bytes, device.boundGuards());
        onFailure(bytes, device.onFailure());
        bytes.number(timers.size());
        timers.forEach((state, ofState) -> {
            bytes.text(state.name());
            bytes.number(ofState.size());
            ofState.forEach((event, delay) -> {
                bytes.text(event.name());
                bytes.number(delay.toNanos());
            });
        });
        bytes.number(queueCapacity);
        bytes.number(pressAge.toNanos());
    }

    private static void onFailure(ByteWriter bytes, Map<State, Map<String, OnFailure>> all) {
        bytes.number(all.size());
        new TreeMap<>(all).forEach((state, byEvent) -> {
            bytes.text(state.name());
            bytes.number(byEvent.size());
            new TreeMap<>(byEvent).forEach((event, then) -> {
                bytes.text(event);
                bytes.text(then.name());
            });
        });
    }

    private static Map<State, Map<String, OnFailure>> onFailure(ByteItems cursor) {
        Map<State, Map<String, OnFailure>> all = new HashMap<>();
        for (int left = cursor.count(); left > 0; left--) {
            Map<String, OnFailure> byEvent = new HashMap<>();
            all.put(new State(cursor.text()), byEvent);
            for (int events = cursor.count(); events > 0; events--) {
                byEvent.put(cursor.text(), OnFailure.valueOf(cursor.text()));
            }
        }
        return all;
    }

    private static void events(ByteWriter bytes, Collection<Event> events) {
        texts(bytes, events.stream().map(Event::name).toList());
    }

    private static void texts(ByteWriter bytes, Collection<String> texts) {
        bytes.names(texts.stream().sorted().toList());
    }

    static Head read(ByteItems cursor) {
        String fingerprint = cursor.text();
        String built = cursor.text();
        StateMachine original = MachineBytes.read(cursor);
        ModelPair models = new ModelPair(original, MachineBytes.read(cursor));
        String boot = cursor.text();
        long wallNanos = cursor.number();
        long nowNanos = cursor.number();
        DeviceEvents device = device(cursor);
        Map<State, Map<Event, Duration>> timers = new TreeMap<>();
        for (int left = cursor.count(); left > 0; left--) {
            timers.put(new State(cursor.text()), timersOfState(cursor));
        }
        int capacity = (int) cursor.number();
        Duration pressAge = Duration.ofNanos(cursor.number());
        cursor.endsAll();
        return new Head(fingerprint, built, models, boot, wallNanos, nowNanos, device, timers, capacity, pressAge);
    }

    private static DeviceEvents device(ByteItems cursor) {
        List<Event> sendable = events(cursor);
        List<Event> spontaneous = events(cursor);
        Map<Event, Integer> costs = new HashMap<>();
        for (int left = cursor.count(); left > 0; left--) {
            costs.put(new Event(cursor.text()), (int) cursor.number());
        }
        List<State> doNotPass = cursor.names().stream().map(State::new).toList();
        return new DeviceEvents(
                sendable.stream().collect(Collectors.toSet()),
                spontaneous.stream().collect(Collectors.toSet()),
                costs,
                doNotPass.stream().collect(Collectors.toSet()),
                cursor.names().stream().collect(Collectors.toSet()),
                onFailure(cursor));
    }

    private static Map<Event, Duration> timersOfState(ByteItems cursor) {
        Map<Event, Duration> timers = new LinkedHashMap<>();
        for (int left = cursor.count(); left > 0; left--) {
            timers.put(new Event(cursor.text()), Duration.ofNanos(cursor.number()));
        }
        return timers;
    }

    private static List<Event> events(ByteItems cursor) {
        return cursor.names().stream().map(Event::new).toList();
    }
}
