package org.evoloop.roomba.session;

import java.util.function.Consumer;
import org.evoloop.roomba.oi.ActuatorCommand.DriveDirect;
import org.evoloop.roomba.oi.Command;
import org.evoloop.roomba.session.inference.ActivityEstimate;

/**
 * Drives the robot backwards off its dock. On the dock it falls back from Safe to Passive mode at once (specification,
 * "Safe Mode"), so the first centimetres are driven in Full mode; once it is off the dock's contacts, it is in Safe
 * mode, in which the robot itself stops at cliffs and wheel drops.
 *
 * <p>Time is counted in frames of the stream, one every 15 ms.
 *
 * <p>Threading: not thread-safe.
 */
final class Undocking {
    /** About the speed at which the robot itself backs off its dock. */
    private static final int BACK_MM_PER_S = -100;

    private static final DriveDirect BACK = new DriveDirect(BACK_MM_PER_S, BACK_MM_PER_S);
    private static final DriveDirect STAND = new DriveDirect(0, 0);

    /** The distance to drive: there it can turn without touching the dock. */
    private static final double FAR_MM = 300;

    /** A robot needs 20 ms after a change of its mode. */
    private static final int DIGEST_FRAMES = 2;

    /** The interval at which the drive command is repeated: 0.75 s. */
    private static final int AGAIN_FRAMES = 50;

    /** The limit for leaving the contacts: 3 s. */
    private static final int STUCK_FRAMES = 200;

    /** The limit for the whole drive: 8 s. */
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

    /** @param sink sends commands */
    Undocking(Consumer<Command> sink, ActivityEstimate estimate) {
        this.sink = sink;
        this.estimate = estimate;
        this.from = OdometryPose.ORIGIN;
    }

    /** Whether the robot is driving off its dock. */
    boolean isUnderWay() {
        return phase != Phase.IDLE;
    }

    /** Starts; the robot was put into Full mode. */
    void begin(Telemetry now) {
        from = now.pose();
        phase = Phase.LEAVING;
        frames = 0;
    }

    /** Handles the next frame; returns whether the drive has ended, successfully or not. */
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
            // The first one may have been taken for the data of an incomplete command.
            sink.accept(new Command.Full());
        } else if (frames % AGAIN_FRAMES == DIGEST_FRAMES) {
            sink.accept(BACK);
        }
        return phase == Phase.IDLE;
    }

    /** Ends without stopping the robot, which something else drives now; returns whether it was driving. */
    boolean giveUp() {
        boolean given = phase != Phase.IDLE;
        phase = Phase.IDLE;
        return given;
    }

    /** Stops the robot if it is driving off its dock. */
    void end() {
        if (giveUp()) {
            sink.accept(STAND);
        }
    }
}
