package org.evoloop.roomba.move;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.Optional;
import org.evoloop.roomba.camera.Look;
import org.evoloop.roomba.move.phase.Sight;
import org.evoloop.roomba.session.OdometryPose;
import org.jspecify.annotations.Nullable;

/**
 * Makes one place of what single looks show. A sighting is believed when {@value Sight#BELIEVED_LOOKS} looks in a row
 * show the same place; a place that is believed follows each look that agrees with it. Places are in the coordinates of
 * the robot's wheels, so that the robot can drive on between two looks.
 *
 * <p>Threading: not thread-safe.
 */
final class GoalWatch {
    /**
     * Two sightings no farther apart are of the same thing: 2.8 % of 3.5 m is what one is wrong by at most, usually.
     */
    static final double SAME_MM = 250;

    /** A place that was not seen for so many times as long as a frame may take is no help to believe a single look. */
    private static final int FORGOTTEN_FRAMES = 3;

    /** For so many times as long the robot's way is known; looks are younger. */
    private static final int TRAIL_FRAMES = 6;

    private record Footprint(long nanos, OdometryPose pose) {}

    private final long frameLimitNanos;
    private final Deque<Footprint> trail = new ArrayDeque<>();
    private long frame;
    private int inARow;
    private @Nullable OdometryPose last;
    private @Nullable OdometryPose goal;
    private long goalNanos;

    GoalWatch(long frameLimitNanos) {
        this.frameLimitNanos = frameLimitNanos;
    }

    /** Takes what was monitored next. */
    Sight update(Percept percept) {
        trail.addLast(new Footprint(percept.nanos(), percept.telemetry().pose()));
        while (percept.nanos() - trail.getFirst().nanos() > TRAIL_FRAMES * frameLimitNanos) {
            trail.removeFirst();
        }
        Look look = percept.look();
        if (look.frame() != frame) {
            frame = look.frame();
            look.sighting()
                    .ifPresentOrElse(
                            seen -> see(
                                    poseAt(look.takenNanos()).beyond(seen.distanceMm(), seen.bearingRad()),
                                    look.takenNanos()),
                            () -> inARow = 0);
        }
        boolean stale = frame == 0 || percept.nanos() - look.takenNanos() > frameLimitNanos;
        return new Sight(stale, frame, look.takenNanos(), inARow > 0, Optional.ofNullable(goal), goalNanos);
    }

    private void see(OdometryPose place, long takenNanos) {
        inARow = isSame(last, place) ? inARow + 1 : 1;
        last = place;
        boolean follows = isSame(goal, place) && takenNanos - goalNanos < FORGOTTEN_FRAMES * frameLimitNanos;
        if (inARow >= Sight.BELIEVED_LOOKS || follows) {
            goal = place;
            goalNanos = takenNanos;
        }
    }

    private static boolean isSame(@Nullable OdometryPose known, OdometryPose place) {
        return known != null && known.distanceTo(place.xMm(), place.yMm()) <= SAME_MM;
    }

    /** Where the robot was when a frame was taken: the last known pose before that. */
    private OdometryPose poseAt(long nanos) {
        OdometryPose pose = trail.getFirst().pose();
        for (Footprint footprint : trail) {
            if (footprint.nanos() - nanos > 0) {
                break;
            }
            pose = footprint.pose();
        }
        return pose;
    }
}
