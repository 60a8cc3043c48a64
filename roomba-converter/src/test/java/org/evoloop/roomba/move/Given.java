package org.evoloop.roomba.move;

import java.util.List;
import java.util.Optional;
import java.util.function.ToIntFunction;
import org.evoloop.roomba.camera.CameraHealth;
import org.evoloop.roomba.camera.Look;
import org.evoloop.roomba.camera.Sighting;
import org.evoloop.roomba.move.Situation.Obstacle;
import org.evoloop.roomba.oi.OiMode;
import org.evoloop.roomba.oi.Packet;
import org.evoloop.roomba.oi.PacketGroup;
import org.evoloop.roomba.oi.SensorValues;
import org.evoloop.roomba.session.Pose;
import org.evoloop.roomba.session.Telemetry;

/** Situations for tests by value: a robot under control at the origin that sees nothing, and what differs from that. */
final class Given {
    static final StartPointSensor.Target MARKER = new StartPointSensor.Target(400, 20, true);
    static final Memory MEMORY = new Memory(MARKER, MoveOptions.defaults());
    static final Situation NOTHING = new Situation(
            0, Pose.ORIGIN, true, Obstacle.NONE, false, false, new Sight(false, 1, 0, false, Optional.empty(), 0), "");

    private Given() {}

    static long millis(long count) {
        return count * 1_000_000;
    }

    /** The same at another time, with another look that is {@code ageMillis} old and shows nothing. */
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

    /** The same with a goal that was seen in the newest look. */
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
                        Optional.of(new Pose(xMm, yMm, 0)),
                        sight.takenNanos()),
                situation.end());
    }

    /** The same with an obstacle. */
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

    /** A frame of the robot's stream. */
    static Telemetry telemetry(long frame, OiMode mode, Pose pose, ToIntFunction<Packet> rest) {
        return new Telemetry(
                frame,
                SensorValues.of(
                        List.of(PacketGroup.values()),
                        packet -> packet == Packet.OI_MODE ? mode.code() : rest.applyAsInt(packet)),
                pose);
    }

    static Look look(long frame, long takenMillis, Sighting... seen) {
        return new Look(
                frame,
                millis(takenMillis),
                CameraHealth.SEEING,
                seen.length == 0 ? Optional.empty() : Optional.of(seen[0]));
    }
}
