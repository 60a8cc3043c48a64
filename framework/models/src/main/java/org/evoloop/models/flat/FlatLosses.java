package org.evoloop.models.flat;

import java.util.ArrayList;
import java.util.List;
import org.evoloop.statemachine.State;
import org.evoloop.statemachine.StateMachine;
import org.evoloop.statemachine.Transition;

/** What no flat drawing of a machine can express. */
public final class FlatLosses {
    private FlatLosses() {}

    /**
     * One line each:
     *
     * <ul>
     *   <li>timers and activities that continue across a transition, since flat states have no enclosing state
     *   <li>several guards of an internal transition, which become one text
     *   <li>that a device state is the one of an enclosing state
     *   <li>states that differ only in what the machine remembers
     *   <li>an event that is deferred under a guard
     * </ul>
     */
    public static List<String> of(StateMachine machine) {
        List<String> losses = new ArrayList<>();
        for (Transition transition : machine.transitions()) {
            if (!transition.internal() && !transition.keeps().isEmpty()) {
                losses.add(transition + " keeps " + String.join(", ", transition.keeps())
                        + " going, which no flat drawing can say");
            }
            if (transition.internal() && transition.event().guards().size() > 1) {
                losses.add("the guards of the internal transition " + transition + " become one text");
            }
        }
        for (State state : machine.states()) {
            machine.deferred(state).stream()
                    .filter(event -> !event.guards().isEmpty())
                    .forEach(event -> losses.add(state + " defers " + event + ", which a flat drawing swallows"));
            if (machine.inheritsDeviceState(state)) {
                losses.add(state + " has the device state " + machine.deviceState(state)
                        + " of a state around it, which becomes its own; remove it there if the device has "
                        + state + ", too");
            }
            if (!machine.withoutMemory(state).equals(state)) {
                losses.add(state + " is the state " + machine.withoutMemory(state)
                        + " with something remembered; a flat drawing makes it a state of its own");
            }
        }
        return losses;
    }
}
