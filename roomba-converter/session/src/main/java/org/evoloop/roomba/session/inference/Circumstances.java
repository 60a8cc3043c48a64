package org.evoloop.roomba.session.inference;

/**
 * Where the robot is and how it fares, whatever it is taken to do.
 *
 * <p>Threading: immutable.
 *
 * @param asleep it hears and says nothing until it is woken
 * @param inTrouble a wheel hangs in the air, or a motor draws too much current: it cannot work
 * @param docked it stands on its dock
 * @param filling the dock fills its battery; not while that is full and only kept so
 * @since 0.1
 */
public record Circumstances(boolean asleep, boolean inTrouble, boolean docked, boolean filling) {
    /** Awake on the floor, and all is well. */
    public static final Circumstances USUAL = new Circumstances(false, false, false, false);

    static final Circumstances ASLEEP = new Circumstances(true, false, false, false);
}
