package org.evoloop.check;

import java.util.HashSet;
import java.util.Set;
import org.evoloop.evolution.DeviceEvents;
import org.evoloop.evolution.ModelPair;
import org.evoloop.statemachine.Event;
import org.jspecify.annotations.Nullable;

/**
 * What is checked, and what is known about the converter around it. What is null is not known, and not judged.
 *
 * <p>Threading: immutable.
 *
 * @param pair need not be an evolution
 * @param device what can be sent, and by which ways
 * @param functions names of the new states for which a function or a timer is registered
 * @param raised names of the events that monitors and functions raise; time triggers need not be among them
 * @param guards texts of the guards that something is bound to
 * @param effects texts of the effects that something is bound to
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
     * Of the models alone: every event of the device can be sent, but its time triggers and those that its model
     * declares to be its own; all guards can be asked.
     */
    public static CheckInput of(ModelPair pair) {
        Set<Event> sendable = new HashSet<>(pair.original().triggers());
        sendable.removeIf(event -> event.timeTrigger().isPresent());
        sendable.removeAll(pair.original().spontaneous());
        DeviceEvents device = new DeviceEvents(sendable, Set.of())
                .withBoundGuards(pair.original().guards());
        return new CheckInput(pair, device, null, null, null, null);
    }

    /** The same with another device; guards that can be asked are named by {@link #withGuards}. */
    public CheckInput withDevice(DeviceEvents other) {
        return new CheckInput(pair, other.withBoundGuards(device.boundGuards()), functions, raised, guards, effects);
    }

    /** The same with events that the device takes of its own accord and that cannot be sent. */
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

    /** The same with functions. */
    public CheckInput withFunctions(Set<String> states) {
        return new CheckInput(pair, device, states, raised, guards, effects);
    }

    /** The same with events that somebody raises. */
    public CheckInput withRaised(Set<String> names) {
        return new CheckInput(pair, device, functions, names, guards, effects);
    }

    /** The same with guards that something is bound to. */
    public CheckInput withGuards(Set<String> texts) {
        return new CheckInput(pair, device.withBoundGuards(texts), functions, raised, texts, effects);
    }

    /** The same with effects that something is bound to. */
    public CheckInput withEffects(Set<String> texts) {
        return new CheckInput(pair, device, functions, raised, guards, texts);
    }
}
