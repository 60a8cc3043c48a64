package org.evoloop.evolution;

/**
 * What follows when a step of a plan fails, so that the device is somewhere on the way.
 *
 * @since 0.1
 */
public enum OnFailure {
    /** The device stays where it is, and the event has failed. */
    STAY,

    /** The device is sent back to where the plan began, if events that can be sent lead there; the event has failed. */
    GO_BACK,

    /** The event goes on by another way, without the step that failed, if there is one; else it has failed. */
    OTHER_WAY
}
