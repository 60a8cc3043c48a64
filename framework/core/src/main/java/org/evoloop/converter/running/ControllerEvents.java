package org.evoloop.converter.running;

import java.util.Set;
import java.util.TreeSet;
import org.evoloop.converter.StateKnowledge;
import org.evoloop.converter.SystemEventConverter;
import org.evoloop.converter.attachment.Friends;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.StateMachine;
import org.evoloop.statemachine.Transition;

/** The events that a controller may raise, as far as models, timers and components show. */
public final class ControllerEvents {
    private ControllerEvents() {}

    /**
     * See {@link SystemEventConverter#controllerEvents}. An event that the device does not have is a controller's if a
     * monitor says so, or if it is accepted in a state of the device, where no function runs, and no timer of that state
     * raises it.
     *
     * @param reported what monitors say that controllers raise
     */
    public static Set<Event> of(StateKnowledge knowledge, Set<Event> sendable, Set<Event> reported) {
        StateMachine original = knowledge.models().original();
        Set<Event> events = new TreeSet<>();
        for (Transition transition : knowledge.models().evolved().transitions()) {
            Event trigger = transition.event().trigger();
            boolean ofController = original.triggers().contains(trigger)
                    ? sendable.contains(trigger)
                    : reported.contains(trigger)
                            || (original.hasAlike(transition.source())
                                    && !Friends.KNOWLEDGE
                                            .of(knowledge)
                                            .timersOf(transition.source())
                                            .containsKey(trigger));
            if (ofController && trigger.timeTrigger().isEmpty()) {
                events.add(trigger);
            }
        }
        return events;
    }
}
