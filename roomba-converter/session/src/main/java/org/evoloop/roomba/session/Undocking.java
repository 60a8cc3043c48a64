package org.evoloop.roomba.session;

import java.util.function.Consumer;
import org.evoloop.roomba.oi.ActuatorCommand.DriveDirect;
import org.evoloop.roomba.oi.Command;
import org.evoloop.roomba.session.inference.ActivityEstimate;

/**
 * Drives the robot backwards off its dock. On the dock it falls back from Safe to Passive mode at once (specification,
 * "Safe Mode"), so the first centimetres are driven in Full mode; as soon as the dock's contacts are gone, Safe mode is
 * on, with the robot's own care for cliffs and wheel drops.
 *
 * <p>Time is counted in frames of the stream, one every 15 ms.
 *
 * <p>Threading: not thread-safe.
 */
final class Undocking {
    /** About as fast as the robot backs off its dock by itself. */
    private static final int BACK_MM_PER_S = -100;

    private static final DriveDirect BACK = new DriveDirect(BACK_MM_PER_S, BACK_MM_PER_S);
    private static final DriveDirect STAND = new DriveDirect(0, 0);

    /** So far the robot drives: from there it turns without touching the dock. */
    private static final double FAR_MM = 300;

    /** A robot needs 20 ms to digest a change of its mode. */
    private static final int DIGEST_FRAMES = 2;

    /** So often it is told to drive: every 0.75 s. */
    private static final int AGAIN_FRAMES = 50;

    /** So long the contacts may last: 3 s. */
    private static final int STUCK_FRAMES = 200;

    /** So long all of it may last: 8 s. */
    private static final int LONGEST_FRAMES = 533;

    private enum Phase {
        IDLE,
        /** In Full mode, on the contacts. */
        LEAVING,
        /** In Safe mode, off them. */
        CLEARING
    }

    private final Consumer<Command> sink;
    private final ActivityEstimate estimate;
    private Phase phase = Phase.IDLE;
    private int frames;
    private OdometryPose from;

    /** @param sink sends what it is given */
    Undocking(Consumer<Command> sink, ActivityEstimate estimate) {
        this.sink = sink;
        this.estimate = estimate;
        this.from = OdometryPose.ORIGIN;
    }

    /** Whether the robot is on its way. */
    boolean isUnderWay() {
        return phase != Phase.IDLE;
    }

    /** Begins with a robot that has been put into Full mode. */
    void begin(Telemetry now) {
        from = now.pose();
        phase = Phase.LEAVING;
        frames = 0;
    }

    /** Takes the next frame; returns whether it was the last one of the way, however that has ended. */
    boolean update(Telemetry now) {
        if (phase == Phase.IDLE) {
            return false;
        }
        frames++;
        boolean far = now.pose().distanceTo(from.xMm(), from.yMm()) >= FAR_MM;
        if (phase == Phase.LEAVING && !now.values().onHomeBase()) {
            phase = Phase.CLEARING;
            frames = 0;
            Command safe = new Command.Safe();
            sink.accept(safe);
            estimate.commanded(safe);
        } else if (phase == Phase.LEAVING && frames >= STUCK_FRAMES) {
            end();
            sink.accept(new Command.Start());
        } else if (phase == Phase.CLEARING && (far || frames >= LONGEST_FRAMES)) {
            end();
        } else if (phase == Phase.LEAVING && frames % AGAIN_FRAMES == 0) {
            // What came first may have been taken for the data of a command of which a part was lost.
            sink.accept(new Command.Full());
        } else if (frames % AGAIN_FRAMES == DIGEST_FRAMES) {
            sink.accept(BACK);
        }
        return phase == Phase.IDLE;
    }

    /** Somebody else moves the robot from here on; returns whether it was on its way. */
    boolean giveUp() {
        boolean given = phase != Phase.IDLE;
        phase = Phase.IDLE;
        return given;
    }

    /** Stops the robot where it is, if it is on its way. */
    void end() {
        if (giveUp()) {
            sink.accept(STAND);
        }
    }
}
