package org.evoloop.roomba.move;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.Optional;
import org.evoloop.roomba.camera.Look;
import org.evoloop.roomba.move.phase.Sight;
import org.evoloop.roomba.session.OdometryPose;
import org.jspecify.annotations.Nullable;

/**
 * Estimates the goal's place from single looks. A sighting is believed when {@value Sight#BELIEVED_LOOKS} looks in a
 * row show the same place; after that, the place follows each look that agrees with it. Places are in odometry
 * coordinates, so the robot can drive between two looks.
 *
 * <p>Threading: not thread-safe.
 */
final class GoalWatch {
    /** Sightings within this distance are of the same object: one is usually wrong by at most 2.8 % of 3.5 m. */
    static final double SAME_MM = 250;

    /** After this many frame limits without a sighting, the old place can no longer confirm a single look. */
    private static final int FORGOTTEN_FRAMES = 3;

    /** How long poses are kept, in frame limits; looks are younger than this. */
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

    /** Processes the next percept. */
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

    /** The robot's pose when a frame was taken: the last known pose before that moment. */
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
