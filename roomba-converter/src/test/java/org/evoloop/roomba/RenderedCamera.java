package org.evoloop.roomba;

import java.time.Duration;
import java.util.Optional;
import org.evoloop.roomba.camera.CameraHealth;
import org.evoloop.roomba.camera.CameraModel;
import org.evoloop.roomba.camera.Look;
import org.evoloop.roomba.camera.MarkerCamera;
import org.evoloop.roomba.camera.MarkerSpec;
import org.evoloop.roomba.camera.Sighting;
import org.evoloop.roomba.camera.vision.MarkerFinder;
import org.evoloop.roomba.camera.vision.OpenCv;
import org.evoloop.roomba.simulator.eye.CameraImage;
import org.evoloop.roomba.simulator.eye.Effects;
import org.evoloop.roomba.simulator.eye.Eye;
import org.evoloop.roomba.simulator.eye.EyeOptions;
import org.evoloop.roomba.simulator.robot.RobotState;
import org.evoloop.roomba.simulator.robot.SimulatedRoomba;
import org.evoloop.roomba.simulator.room.Pose;
import org.evoloop.roomba.simulator.room.Room;
import org.evoloop.time.ManualClock;

/**
 * A camera that finds its looks with OpenCV in rendered pictures, under a manual clock. While the robot turns fast no
 * picture is rendered: a real one would only be blurred, and Move does not look then.
 */
final class RenderedCamera implements MarkerCamera {
    private static final Duration FRAME = Duration.ofMillis(100);
    private static final Duration LATENCY = Duration.ofMillis(60);
    private static final double FAST_TURN_RAD_PER_S = 0.6;

    private final SimulatedRoomba robot;
    private final Room room;
    private final ManualClock clock;
    private final Eye eye;
    private final MarkerFinder finder = OpenCv.vision().finder(MarkerSpec.DEFAULT, CameraModel.DEFAULT);
    private Look newest =
            new Look(0, 0, new CameraHealth(CameraHealth.Condition.OPENING, "it is opening"), Optional.empty());
    private long pictures;
    private boolean closed;

    RenderedCamera(SimulatedRoomba robot, Room room, ManualClock clock, Effects effects, long seed) {
        this.robot = robot;
        this.room = room;
        this.clock = clock;
        this.eye = new Eye(EyeOptions.defaults().withSeed(seed).withEffects(effects));
        clock.schedule(FRAME, this::take);
    }

    private void take() {
        if (closed) {
            return;
        }
        clock.schedule(FRAME, this::take);
        RobotState state = robot.state();
        double turnRadPerS = (state.rightMmPerS() - state.leftMmPerS()) / Pose.WHEEL_BASE_MM;
        Optional<Sighting> sighting =
                Math.abs(turnRadPerS) > FAST_TURN_RAD_PER_S ? Optional.empty() : look(state.pose(), turnRadPerS);
        clock.schedule(
                LATENCY, () -> newest = new Look(newest.frame() + 1, clock.nanoTime(), CameraHealth.SEEING, sighting));
    }

    private Optional<Sighting> look(Pose pose, double turnRadPerS) {
        CameraImage picture = eye.render(room, pose, turnRadPerS, ++pictures);
        return finder.find(picture.bgr(), picture.widthPx(), picture.heightPx());
    }

    @Override
    public Look newest() {
        return newest;
    }

    @Override
    public Runnable onLook(Runnable listener) {
        throw new UnsupportedOperationException("Move asks for the newest look");
    }

    @Override
    public void close() {
        closed = true;
        finder.close();
    }
}
