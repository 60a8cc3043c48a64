package org.evoloop.evolution;

import static java.util.Objects.requireNonNull;

import java.util.HashMap;
import java.util.LinkedHashSet;
import java.util.Map;
import java.util.Set;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.State;
import org.evoloop.statemachine.StateMachine;
import org.evoloop.statemachine.Transition;

/**
 * The events between converter and device, and the paths through the device's states that a plan may take.
 *
 * <p>Threading: immutable.
 *
 * @param sendable events, without guards, that the converter can send; plans consist only of these
 * @param spontaneous events, without guards, that the device takes by itself: always, such as that it has finished, or
 *     although they can be sent too, such as those of its own buttons
 * @param costs the cost of sending an event, from 1 to {@value #MAX_COST}; 1 if not listed
 * @param doNotPass states of the device in which a path may begin or end, but through which none may lead
 * @param boundGuards texts of the guards that can be evaluated; no path uses a transition with any other guard
 * @param onFailure by state of the new model and event, what follows when a step of the plan fails; by default the
 *     device stays where it is. Events are written as by {@link Event#toString}; without guards, all events of the
 *     trigger are meant
 * @since 0.1
 */
public record DeviceEvents(
        Set<Event> sendable,
        Set<Event> spontaneous,
        Map<Event, Integer> costs,
        Set<State> doNotPass,
        Set<String> boundGuards,
        Map<State, Map<String, OnFailure>> onFailure) {
    /** The highest cost of one event. */
    public static final int MAX_COST = 1_000_000;

    /**
     * @throws NullPointerException if one of them is null; the message says which
     * @throws IllegalArgumentException if a cost is out of range
     */
    public DeviceEvents {
        requireNonNull(sendable, "the events that can be sent are null; Set.of() are none");
        requireNonNull(spontaneous, "the device's own events are null; Set.of() are none");
        requireNonNull(costs, "the costs of events are null; Map.of() are none");
        requireNonNull(doNotPass, "the states not to be passed are null; Set.of() are none");
        requireNonNull(boundGuards, "the bound guards are null; Set.of() are none");
        requireNonNull(onFailure, "what follows on failure is null; Map.of() is nothing");
        sendable = Set.copyOf(sendable);
        spontaneous = Set.copyOf(spontaneous);
        costs = Map.copyOf(costs);
        doNotPass = Set.copyOf(doNotPass);
        boundGuards = Set.copyOf(boundGuards);
        Map<State, Map<String, OnFailure>> copy = new HashMap<>();
        onFailure.forEach((state, byEvent) -> copy.put(state, Map.copyOf(byEvent)));
        onFailure = Map.copyOf(copy);
        costs.forEach((event, cost) -> {
            if (cost < 1 || cost > MAX_COST) {
                throw new IllegalArgumentException(
                        "the cost of " + event + " is " + cost + ", allowed is 1 to " + MAX_COST);
            }
        });
    }

    /** Every event costs the same, every state may be passed, and no guard is bound. */
    public DeviceEvents(Set<Event> sendable, Set<Event> spontaneous) {
        this(sendable, spontaneous, Map.of(), Set.of(), Set.of(), Map.of());
    }

    /**
     * What is assumed of a device of which only the model is known: every event can be sent but time triggers and those
     * that it declares to be its own, and every guard can be evaluated.
     */
    public static DeviceEvents assumedOf(StateMachine original) {
        Set<Event> sent = new LinkedHashSet<>(original.triggers());
        sent.removeAll(new DeviceEvents(Set.of(), Set.of()).declaredBy(original).spontaneous());
        return new DeviceEvents(sent, Set.of()).withBoundGuards(original.guards());
    }

    /**
     * A copy that includes the events that {@code original} declares to be the device's own, such as its time triggers.
     */
    public DeviceEvents declaredBy(StateMachine original) {
        Set<Event> all = new LinkedHashSet<>(spontaneous);
        all.addAll(original.spontaneous());
        for (Event trigger : original.triggers()) {
            if (!sendable.contains(trigger) && trigger.timeTrigger().isPresent()) {
                all.add(trigger);
            }
        }
        return new DeviceEvents(sendable, all, costs, doNotPass, boundGuards, onFailure);
    }

    /** Whether only the device itself can take {@code trigger}. */
    public boolean isOwn(Event trigger) {
        return spontaneous.contains(trigger) && !sendable.contains(trigger);
    }

    /** For people: why a controller's press of {@code trigger}, which is the device's {@linkplain #isOwn own}, is refused. */
    public static String notPressed(Event trigger) {
        return "only the device itself can raise " + trigger.trigger()
                + ", so it cannot be pressed; a monitor reports it" + " with fromDevice";
    }

    /** The events of {@code original} that no component sends and that are not declared spontaneous either. */
    public Set<Event> unsendable(StateMachine original) {
        Set<Event> left = new LinkedHashSet<>(original.triggers());
        left.removeAll(sendable);
        left.removeAll(declaredBy(original).spontaneous());
        return left;
    }

    /** A copy with other costs. */
    public DeviceEvents withCosts(Map<Event, Integer> newCosts) {
        return new DeviceEvents(sendable, spontaneous, newCosts, doNotPass, boundGuards, onFailure);
    }

    /** A copy with other states that must not be passed. */
    public DeviceEvents withDoNotPass(Set<State> states) {
        return new DeviceEvents(sendable, spontaneous, costs, states, boundGuards, onFailure);
    }

    /** A copy with other guards that can be evaluated. */
    public DeviceEvents withBoundGuards(Set<String> texts) {
        return new DeviceEvents(sendable, spontaneous, costs, doNotPass, texts, onFailure);
    }

    /** A copy with other recoveries from failed steps. */
    public DeviceEvents withOnFailure(Map<State, Map<String, OnFailure>> consequences) {
        return new DeviceEvents(sendable, spontaneous, costs, doNotPass, boundGuards, consequences);
    }

    /** What follows when a step of a plan for {@code transition} of the new model fails. */
    public OnFailure onFailure(Transition transition) {
        Map<String, OnFailure> inState = onFailure.getOrDefault(transition.source(), Map.of());
        OnFailure ofTrigger = inState.getOrDefault(transition.event().trigger().name(), OnFailure.STAY);
        return inState.getOrDefault(transition.event().toString(), ofTrigger);
    }

    int costOf(Event trigger) {
        return costs.getOrDefault(trigger, 1);
    }
}
