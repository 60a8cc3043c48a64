package org.evoloop.roomba.simulator.behavior;

import org.evoloop.roomba.simulator.body.Body;
import org.evoloop.roomba.simulator.room.Point;
import org.evoloop.roomba.simulator.room.Pose;

/** Wanders until the robot receives the dock's beams, aligns with the dock and drives onto it. */
public final class DockSeeking implements Behavior {
    /** The look-ahead distance on the dock's centre line, so that the robot approaches the dock straight. */
    private static final double LOOK_AHEAD_MM = 250;

    private static final double APPROACH_MM_PER_S = 170;

    /** The distance from the dock at which a robot that comes from the side aligns with it. */
    private static final double LINE_UP_MM = 700;

    /** Beyond this distance, a robot that is already aligned need not back up. */
    private static final double FAR_MM = 400;

    private static final double IN_LINE_MM = 60;
    private static final double NEAR_MM = 100;

    /** The speed of the last centimetres, aligned with the dock. */
    private static final double CREEP_MM_PER_S = 57;

    private final Wandering wandering = new Wandering();
    private final Reflex reflex = new Reflex();
    private boolean lined;

    @Override
    public boolean steer(Body body) {
        if (body.surroundings().docked()) {
            return false;
        }
        if (reflex.steer(body)) {
            lined = false;
            return !reflex.isStuck();
        }
        Pose dock = body.room().dock().orElse(null);
        if (dock == null || !body.surroundings().seesDock()) {
            lined = false;
            return wandering.steer(body);
        }
        approach(body, dock);
        return true;
    }

    private void approach(Body body, Pose dock) {
        Pose pose = body.pose();
        Point inDockFrame = dock.seen(pose.center());
        double aheadMm = inDockFrame.xMm();
        Point lineUp = dock.ahead(-LINE_UP_MM, 0);
        lined |= pose.distanceMmTo(lineUp) < NEAR_MM || (Math.abs(inDockFrame.yMm()) < IN_LINE_MM && aheadMm < -FAR_MM);
        if (!lined) {
            Pursuit.steer(body, lineUp, pose.distanceMmTo(lineUp) / APPROACH_MM_PER_S);
        } else if (aheadMm > -NEAR_MM / 2) {
            // This close, drive straight: an arc would not end aligned.
            body.drive(CREEP_MM_PER_S, CREEP_MM_PER_S);
        } else {
            Pursuit.steer(
                    body,
                    dock.ahead(Math.min(aheadMm + LOOK_AHEAD_MM, LOOK_AHEAD_MM), 0),
                    LOOK_AHEAD_MM / APPROACH_MM_PER_S);
        }
    }
}
