package org.evoloop.evolution;

import java.util.Set;
import org.evoloop.statemachine.Event;

/**
 * What passes between converter and device.
 *
 * <p>Threading: immutable.
 *
 * @param sendable events that the converter can send; only these make up a plan
 * @param spontaneous events that the device may take by itself although they can be sent too, such as those of its own
 *     buttons. Events of the original model that cannot be sent are always the device's own
 */
public record DeviceEvents(Set<Event> sendable, Set<Event> spontaneous) {

    public DeviceEvents {
        sendable = Set.copyOf(sendable);
        spontaneous = Set.copyOf(spontaneous);
    }
}
