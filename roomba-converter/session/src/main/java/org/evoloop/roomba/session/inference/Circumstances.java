package org.evoloop.roomba.session.inference;

import org.jspecify.annotations.Nullable;

/**
 * The robot's circumstances, independent of its activity.
 *
 * <p>Threading: immutable.
 *
 * @param asleep it neither receives nor sends anything until it is woken
 * @param inTrouble a wheel hangs in the air, or a motor draws too much current: it cannot work
 * @param docked it is on its dock
 * @param filling the dock charges its battery; false while the battery is full and only kept full
 * @since 0.1
 */
public record Circumstances(boolean asleep, boolean inTrouble, boolean docked, boolean filling) {
    /** Awake, on the floor and without trouble. */
    public static final Circumstances USUAL = new Circumstances(false, false, false, false);

    static final Circumstances ASLEEP = new Circumstances(true, false, false, false);

    // Compared in each frame. The methods that Java generates are slow unless the JVM's last compiler has compiled
    // them.

    @Override
    public boolean equals(@Nullable Object other) {
        return other instanceof Circumstances that
                && asleep == that.asleep
                && inTrouble == that.inTrouble
                && docked == that.docked
                && filling == that.filling;
    }

    @Override
    public int hashCode() {
        return (asleep ? 8 : 0) + (inTrouble ? 4 : 0) + (docked ? 2 : 0) + (filling ? 1 : 0);
    }
}
