package org.evoloop.roomba.move.phase;

import java.time.Duration;
import java.util.Optional;
import org.evoloop.roomba.move.phase.Situation.Obstacle;
import org.evoloop.roomba.session.OdometryPose;

/** Situations as values for tests: a robot under control at the origin that sees nothing, and variations of that. */
final class Given {
    private static final Target MARKER = new Target(400, 20, true);
    static final Memory MEMORY = new Memory(MARKER, Duration.ofMillis(300), Duration.ofMillis(250));
    static final Situation NOTHING = new Situation(
            0,
            OdometryPose.ORIGIN,
            true,
            Obstacle.NONE,
            false,
            false,
            new Sight(false, 1, 0, false, Optional.empty(), 0),
            Ending.NONE);

    private Given() {}

    static long millis(long count) {
        return count * 1_000_000;
    }

    /** The same situation at another time, with another look that is {@code ageMillis} old and shows nothing. */
    static Situation at(Situation situation, long millis, long frame, long ageMillis) {
        Sight sight = situation.sight();
        return new Situation(
                millis(millis),
                situation.pose(),
                situation.obeys(),
                situation.obstacle(),
                situation.edge(),
                situation.near(),
                new Sight(
                        ageMillis > 300,
                        frame,
                        millis(millis - ageMillis),
                        sight.promising(),
                        sight.goal(),
                        sight.goalNanos()),
                situation.end());
    }

    /** The same situation with a goal that was seen in the newest look. */
    static Situation seeing(Situation situation, double xMm, double yMm) {
        Sight sight = situation.sight();
        return new Situation(
                situation.nanos(),
                situation.pose(),
                situation.obeys(),
                situation.obstacle(),
                situation.edge(),
                situation.near(),
                new Sight(
                        sight.stale(),
                        sight.frame(),
                        sight.takenNanos(),
                        true,
                        Optional.of(new OdometryPose(xMm, yMm, 0)),
                        sight.takenNanos()),
                situation.end());
    }

    /** The same situation with an obstacle. */
    static Situation touching(Situation situation, Obstacle obstacle, boolean edge) {
        return new Situation(
                situation.nanos(),
                situation.pose(),
                situation.obeys(),
                obstacle,
                edge,
                situation.near(),
                situation.sight(),
                situation.end());
    }
}
