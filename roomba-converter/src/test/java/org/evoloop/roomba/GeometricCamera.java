package org.evoloop.roomba;

import java.time.Duration;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import java.util.concurrent.CopyOnWriteArrayList;
import org.evoloop.roomba.camera.CameraHealth;
import org.evoloop.roomba.camera.Look;
import org.evoloop.roomba.camera.MarkerCamera;
import org.evoloop.roomba.camera.Sighting;
import org.evoloop.roomba.simulator.robot.SimulatedRoomba;
import org.evoloop.roomba.simulator.room.Pose;
import org.evoloop.roomba.simulator.room.Room;
import org.evoloop.time.ManualClock;
import org.jspecify.annotations.Nullable;

/**
 * A camera that computes its looks geometrically from the robot's true pose, with the measured errors of a real one.
 * Nothing is rendered, so many rooms can be tried.
 */
final class GeometricCamera implements MarkerCamera {
    private static final Duration FRAME = Duration.ofNanos(66_666_667);

    /** The time from taking a frame to its arrival. */
    private static final Duration LATENCY = Duration.ofMillis(50);

    private static final double HALF_VIEW_RAD = Math.toRadians(30);
    private static final double MARKER_MM = 190;
    private static final double NEAREST_MM = 150;
    private static final double FARTHEST_MM = 3_500;
    private static final double MOST_OBLIQUE_RAD = Math.toRadians(60);

    private final SimulatedRoomba robot;
    private final Room room;
    private final ManualClock clock;
    private final Random random;
    private final List<Runnable> listeners = new CopyOnWriteArrayList<>();
    private @Nullable Pose marker;
    private Look newest =
            new Look(0, 0, new CameraHealth(CameraHealth.Condition.OPENING, "it is opening"), Optional.empty());
    private boolean stalled;
    private @Nullable RuntimeException broken;
    double lostShare = 0.05;

    /** @param marker its centre and direction; null if there is none */
    GeometricCamera(SimulatedRoomba robot, Room room, ManualClock clock, @Nullable Pose marker, long seed) {
        this.robot = robot;
        this.room = room;
        this.clock = clock;
        this.marker = marker;
        this.random = new Random(seed);
        clock.schedule(FRAME, this::take);
    }

    private void take() {
        clock.schedule(FRAME, this::take);
        if (!stalled) {
            Optional<Sighting> sighting = sighting(robot.state().pose());
            clock.schedule(LATENCY, () -> {
                newest = new Look(newest.frame() + 1, clock.nanoTime(), CameraHealth.SEEING, sighting);
                listeners.forEach(Runnable::run);
            });
        }
    }

    private Optional<Sighting> sighting(Pose eye) {
        Pose seen = marker;
        if (seen == null || random.nextDouble() < lostShare) {
            return Optional.empty();
        }
        double distanceMm = eye.distanceMmTo(seen.center());
        double bearingRad = eye.bearingRadTo(seen.xMm(), seen.yMm());
        double obliqueRad = Math.abs(seen.bearingRadTo(eye.xMm(), eye.yMm()));
        double edgeRad = Math.atan(MARKER_MM / 2 / distanceMm);
        if (distanceMm < NEAREST_MM
                || distanceMm > FARTHEST_MM
                || Math.abs(bearingRad) + edgeRad > HALF_VIEW_RAD
                || obliqueRad > MOST_OBLIQUE_RAD) {
            return Optional.empty();
        }
        for (int side = -1; side <= 1; side++) {
            Pose target = seen.at(seen.ahead(2, side * MARKER_MM / 2));
            if (room.freeMm(eye, eye.bearingRadTo(target.xMm(), target.yMm()))
                    < eye.distanceMmTo(target.center()) - 1) {
                return Optional.empty();
            }
        }
        return Optional.of(new Sighting(
                distanceMm * (1 + 0.01 * random.nextGaussian()),
                bearingRad + Math.toRadians(0.05) * random.nextGaussian()));
    }

    /** Moves the marker, or removes it. */
    void moveMarker(@Nullable Pose place) {
        marker = place;
    }

    /** Stops or resumes the frames. */
    void setStalled(boolean nothingComes) {
        stalled = nothingComes;
    }

    /** Requests for a look throw this from now on. */
    void breakDown(RuntimeException failure) {
        broken = failure;
    }

    @Override
    public Look newest() {
        RuntimeException failure = broken;
        if (failure != null) {
            throw failure;
        }
        return newest;
    }

    @Override
    public Runnable onLook(Runnable listener) {
        listeners.add(listener);
        return () -> listeners.remove(listener);
    }

    @Override
    public void close() {
        listeners.clear();
    }
}
