package org.evoloop.check;

import java.util.HashSet;
import java.util.Set;
import org.evoloop.evolution.DeviceEvents;
import org.evoloop.evolution.ModelPair;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.State;
import org.evoloop.statemachine.StateMachine;
import org.jspecify.annotations.Nullable;

/**
 * The pair to check, and what is known about its converter. A null component is unknown, and the rules that need it are
 * skipped.
 *
 * <p>Threading: immutable.
 *
 * @param pair need not be an evolution
 * @param device the events that can be sent, and the allowed paths
 * @param functions names of the new states for which a function or a timer is registered
 * @param raised names of the events that monitors and functions raise; time triggers need not be among them
 * @param guards texts of the bound guards
 * @param effects texts of the bound effects
 * @since 0.1
 */
public record CheckInput(
        ModelPair pair,
        DeviceEvents device,
        @Nullable Set<String> functions,
        @Nullable Set<String> raised,
        @Nullable Set<String> guards,
        @Nullable Set<String> effects) {

    /**
     * An input of the models alone: every event of the device can be sent, except its time triggers and those that its
     * model declares to be its own; all guards can be evaluated.
     */
    public static CheckInput of(ModelPair pair) {
        Set<Event> sendable = new HashSet<>(pair.original().triggers());
        sendable.removeIf(event -> event.timeTrigger().isPresent());
        sendable.removeAll(pair.original().spontaneous());
        DeviceEvents device = new DeviceEvents(sendable, Set.of())
                .withBoundGuards(pair.original().guards());
        return new CheckInput(pair, device, null, null, null, null);
    }

    /** A copy with another device; {@link #withGuards} sets the bound guards. */
    public CheckInput withDevice(DeviceEvents other) {
        return new CheckInput(pair, other.withBoundGuards(device.boundGuards()), functions, raised, guards, effects);
    }

    /** A copy in which no event is urgent. */
    public CheckInput withoutUrgent() {
        return new CheckInput(pair.withoutUrgent(), device, functions, raised, guards, effects);
    }

    /** A copy with events that the device takes by itself and that cannot be sent. */
    public CheckInput withOwnEvents(Set<String> names) {
        Set<Event> sendable = new HashSet<>(device.sendable());
        Set<Event> spontaneous = new HashSet<>(device.spontaneous());
        for (String name : names) {
            sendable.remove(new Event(name));
            spontaneous.add(new Event(name));
        }
        return withDevice(new DeviceEvents(
                sendable, spontaneous, device.costs(), device.doNotPass(), device.boundGuards(), device.onFailure()));
    }

    /** A copy with functions. */
    public CheckInput withFunctions(Set<String> states) {
        return new CheckInput(pair, device, states, raised, guards, effects);
    }

    /**
     * A copy in which the function of a state of the new model, with whatever history, may send an event, as the
     * converter's code says it.
     */
    public CheckInput withSends(String state, String event) {
        StateMachine evolved = pair.evolved();
        for (State each : pair.evolved().states()) {
            if (each.name().equals(state) || evolved.withoutMemory(each).name().equals(state)) {
                evolved = evolved.withSends(each, new Event(event));
            }
        }
        return new CheckInput(new ModelPair(pair.original(), evolved), device, functions, raised, guards, effects);
    }

    /** A copy with the events that monitors and functions raise. */
    public CheckInput withRaised(Set<String> names) {
        return new CheckInput(pair, device, functions, names, guards, effects);
    }

    /** A copy with bound guards. */
    public CheckInput withGuards(Set<String> texts) {
        return new CheckInput(pair, device.withBoundGuards(texts), functions, raised, texts, effects);
    }

    /** A copy with bound effects. */
    public CheckInput withEffects(Set<String> texts) {
        return new CheckInput(pair, device, functions, raised, guards, texts);
    }
}
