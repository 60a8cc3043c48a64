package org.evoloop.roomba.simulator.robot;

/**
 * The robot's true activity. No packet of the Open Interface shows it; {@code RobotState} does.
 *
 * <pre>
 *            CLEAN                 CLEAN, SPOT or DOCK
 *   OFF ----------------&gt; ON ------------------------------&gt; CLEAN, SPOT or DOCK
 *    ^                    ^                                          |
 *    |  command Power     |  any of the three, or SPOT has ended     |
 *    +---- (from all)     +------------------------------------------+
 * </pre>
 *
 * <p>The arrows are presses of the robot's buttons, which it obeys in the modes Off and Passive. The commands Safe and
 * Full lead to ON from everywhere; the commands Clean, Max, Spot and Seek Dock lead from OFF and ON to the activity,
 * and from an activity to ON.
 *
 * <p>By itself, every activity leads to ON when the robot loses its floor, is stuck or gets onto its dock, and CLEAN
 * leads to DOCK, or without a dock to ON, when the battery is low. A sleeping robot is OFF.
 *
 * @since 0.1
 */
public enum RobotActivity {
    /** Standby: it has power and listens, its light is off. */
    OFF,
    /** On and idle. */
    ON,
    /** Cleans the room. */
    CLEAN,
    /** Cleans a spot, in a spiral. */
    SPOT,
    /** Looks for its dock. */
    DOCK;

    /** Whether the robot drives by itself. */
    public boolean isRunning() {
        return this != OFF && this != ON;
    }
}
