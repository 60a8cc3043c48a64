package org.evoloop.evolution;

/**
 * Where an event came from.
 *
 * @since 0.1
 */
public enum Source {
    /** A control of the controller: a wall switch, a remote, an app. */
    CONTROLLER,
    /** A control on the device itself. */
    PANEL,
    /** The device by itself: it finished something, for example. */
    DEVICE,
    /** A timer that the framework keeps for a state. */
    TIMER,
    /** A new function that runs on this computer. */
    FUNCTION,
    /** A property that is watched over time, when it is violated. */
    PROPERTY,
    /** The person who operates the converter. */
    OWNER;

    /** Whether a person or program outside operated a control; every other source is internal to the evolved system. */
    public boolean isButton() {
        return this == CONTROLLER || this == PANEL;
    }
}
