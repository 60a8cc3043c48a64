package org.evoloop.evolution;

/**
 * What follows when a step of a plan fails and leaves the device in an intermediate state.
 *
 * @since 0.1
 */
public enum OnFailure {
    /** The device stays where it is, and the event has failed. */
    STAY,

    /**
     * The device is sent back to the state where the plan began, if events that can be sent lead there; the event has
     * failed.
     */
    GO_BACK,

    /** The event continues on another path, without the failed step, if there is one; else it has failed. */
    OTHER_WAY
}
