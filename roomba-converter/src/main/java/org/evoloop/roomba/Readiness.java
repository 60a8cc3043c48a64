package org.evoloop.roomba;

import java.util.function.Supplier;
import org.evoloop.function.Visit;
import org.evoloop.roomba.session.RoombaSession;
import org.evoloop.roomba.session.Telemetry;
import org.evoloop.statemachine.State;

/**
 * Prepares the robot for a function that drives it: it has to be on, on the floor, and sufficiently charged. Events of
 * its own model do this, in order with all others.
 */
final class Readiness {
    /** Below this charge, in percent, the robot is charged first. */
    static final int LOW_PERCENT = 20;

    private static final int FULL_PERCENT = 100;

    private final RoombaSession session;
    private final Supplier<State> device;

    /** @param device supplies the state of the robot's model */
    Readiness(RoombaSession session, Supplier<State> device) {
        this.session = session;
        this.device = device;
    }

    /** Returns whether the robot is ready or is being made ready; if not, the visit ends with {@code lowBattery}. */
    boolean provide(Visit visit) throws InterruptedException {
        if (visit.accepts(RobotEvents.LOW_BATTERY) && isLow()) {
            visit.finish(RobotEvents.LOW_BATTERY);
            return false;
        }
        switch (device.get().name()) {
            case RobotEvents.STATE_CHARGING, RobotEvents.STATE_CHARGED -> visit.send(RobotEvents.UNDOCK);
            case RobotEvents.STATE_ON, RobotEvents.STATE_ERROR -> {}
            // The robot is switched on, woken, or paused.
            default -> visit.send(RobotEvents.CLEAN);
        }
        return true;
    }

    private boolean isLow() {
        Telemetry now = session.latest();
        return now != null && now.values().batteryPercent().orElse(FULL_PERCENT) < LOW_PERCENT;
    }
}
