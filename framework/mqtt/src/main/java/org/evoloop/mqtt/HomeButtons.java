package org.evoloop.mqtt;

import java.util.Set;
import java.util.TreeSet;
import org.evoloop.converter.SystemEventConverter;
import org.evoloop.evolution.ModelPair;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.StateMachine;
import org.evoloop.statemachine.Transition;

/** The events that a controller may raise, as far as models and components show. */
final class HomeButtons {
    private HomeButtons() {}

    /**
     * The events that the new model accepts in a state that the device also has, except timers and what the device does
     * by itself. Events accepted only in new states are raised by their functions and timers.
     */
    static Set<String> of(SystemEventConverter converter) {
        ModelPair models = converter.knowledge().models();
        Set<Event> sendable = converter.sendableEvents();
        StateMachine original = models.original();
        Set<String> names = new TreeSet<>();
        for (Transition transition : models.evolved().transitions()) {
            Event trigger = transition.event().trigger();
            boolean ofDevice = original.triggers().contains(trigger);
            if (original.hasAlike(transition.source())
                    && trigger.timeTrigger().isEmpty()
                    && (sendable.contains(trigger) || !ofDevice)
                    && !(original.spontaneous().contains(trigger) && !sendable.contains(trigger))) {
                names.add(trigger.name());
            }
        }
        return names;
    }
}
