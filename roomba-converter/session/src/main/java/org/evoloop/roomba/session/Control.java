package org.evoloop.roomba.session;

import org.evoloop.roomba.oi.ActuatorCommand;
import org.evoloop.roomba.oi.Command;
import org.evoloop.roomba.oi.Packet;
import org.evoloop.roomba.oi.SensorValues;
import org.evoloop.roomba.session.connection.RobotConnection;
import org.evoloop.roomba.session.inference.ActivityEstimate;
import org.evoloop.roomba.session.inference.CommandEffect;
import org.evoloop.roomba.session.inference.FrameSpan;
import org.evoloop.roomba.session.inference.SpotWatch;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Keeps the robot under control or leaves it alone, as requested: takes control again after the robot has left it,
 * repeats lost commands, and stops a robot that was unreachable.
 *
 * <p>Threading: not thread-safe, but the methods {@code is...} may be called from any thread.
 */
final class Control {
    private static final Logger LOG = LoggerFactory.getLogger(RoombaSession.class);

    /** The frames after which the activity of a robot that was unreachable is known. */
    private static final int SETTLING_FRAMES = 4;

    /**
     * A command that ends control shows in the mode within a few frames; otherwise the motors must have started within
     * this many. A command that has arrived must not be sent twice: a second Clean stops the cleaning.
     */
    static final int CONFIRM_FRAMES = ActivityEstimate.START_FRAMES;

    /**
     * The bytes that complete a pending command take 45 ms on the line, and a robot needs 20 ms after a change of its
     * mode.
     */
    private static final int DIGEST_FRAMES = 6;

    /** Three Safe commands, with pending commands completed in between. */
    private static final int TRIES_ON_DOCK = 5;

    /** The knowledge of the robot's activity after a frame. */
    enum Known {
        NOTHING,
        /** It is on and idle, whatever the estimate was. */
        ON,
        /** Its activity is the estimated one. */
        AS_ESTIMATED
    }

    private final RobotConnection connection;
    private final ActivityEstimate estimate;
    private final FrameSpan withControl = new FrameSpan();
    private final FrameSpan withoutControl = new FrameSpan();
    private boolean engaged;
    private volatile boolean wanted;
    private volatile boolean regaining;
    /** The last command, if it ends control and frames may still show the time before it. */
    private @Nullable Command ending;

    private final FrameSpan sinceEnding = new FrameSpan();
    private @Nullable Command unconfirmed;
    private boolean halted;
    private @Nullable Command again;
    private int againFrames;
    private boolean outOfSight;
    private int settlingFrames;
    private boolean mayHaveMissed = true;
    private int engagedFrames;
    private boolean underControl;
    private int tries;

    Control(RobotConnection connection, ActivityEstimate estimate) {
        this.connection = connection;
        this.estimate = estimate;
    }

    /** Requests control now, and again whenever the robot has left Safe mode by itself. */
    void want() {
        wanted = true;
        engaged = true;
    }

    /** Leaves the robot alone for now; control is taken if it becomes reachable again after a loss. */
    void leaveAlone() {
        wanted = false;
        engaged = true;
    }

    /** Leaves the robot alone permanently. */
    void release() {
        if (regaining) {
            loseSight();
        }
        engaged = false;
        mayHaveMissed = true;
        engagedFrames = 0;
        wanted = false;
        regaining = false;
    }

    /** The last command is not repeated, even if it was lost. */
    void forgetCommand() {
        unconfirmed = null;
        again = null;
    }

    /** Whether control is wanted now. */
    boolean isWanted() {
        return wanted;
    }

    /** Whether the robot has just become reachable again and is about to be stopped. */
    boolean isRegaining() {
        return regaining;
    }

    /** A command is about to be sent. */
    void sending(Command command) {
        if (command.opcode().endsControl()) {
            // It is about to be without control as it should. A Safe because of earlier frames would end its work.
            withoutControl.restart();
        }
    }

    /** A command has been sent. */
    void commanded(Command command) {
        if (engaged) {
            // After a command the estimate is known; frames already on their way show the state before it.
            mayHaveMissed = false;
        }
        unconfirmed = null;
        halted = false;
        again = null;
        ending = null;
        if (command.opcode().endsControl()) {
            unconfirmed = underControl ? command : null;
            ending = command;
            sinceEnding.restart();
            // Restart the count: frames already on their way still show control.
            withControl.restart();
        }
    }

    /** The robot is unreachable, so its activity is unknown. */
    void loseSight() {
        outOfSight = true;
        settlingFrames = SETTLING_FRAMES;
    }

    /**
     * Handles the next frame; returns what it shows of the robot's activity.
     *
     * @param nowNanos the time on a monotonic clock
     */
    Known update(Telemetry now, long nowNanos) {
        sendAgain();
        comeBackIntoSight();
        boolean on = seeControl(now.isUnderControl(), nowNanos);
        boolean mustReport = mustReport();
        on |= takeBack(now, nowNanos);
        return on ? Known.ON : mustReport ? Known.AS_ESTIMATED : Known.NOTHING;
    }

    /**
     * Handles a robot that is reachable again. Its frames do not show what its owner made it do in the meantime:
     * cleaning and spot cleaning look the same. So control is taken if it is wanted at all, which ends any activity, so
     * that its state is on.
     */
    private void comeBackIntoSight() {
        if (outOfSight && engaged && --settlingFrames <= 0) {
            outOfSight = false;
            regaining = true;
            connection.trySend(new Command.Safe());
            connection.trySend(new ActuatorCommand.DriveDirect(0, 0));
        }
    }

    /** Returns whether the robot is known to be idle. */
    private boolean seeControl(boolean now, long nowNanos) {
        sinceEnding.count(nowNanos);
        if (sinceEnding.hasLasted(CommandEffect.SHOW_FRAMES)) {
            ending = null;
        }
        boolean begins = now && !underControl;
        if (begins && ending == null) {
            // Only at the start of control: a command that ends it takes some frames to show.
            estimate.controlled();
        } else if (begins) {
            unconfirmed = ending;
        }
        underControl = now;
        boolean on = underControl && regaining;
        regaining &= !on;
        Command command = unconfirmed;
        if (!underControl) {
            withControl.restart();
            unconfirmed = null;
            return on;
        }
        withControl.count(nowNanos);
        if (command != null) {
            confirm(command);
        } else if (withControl.hasLasted(SpotWatch.QUIET_FRAMES)) {
            withControl.restart();
            // Still under control though it was released, and at rest: it is on.
            on |= engaged && !wanted && estimate.isAtRest();
        }
        return on;
    }

    /**
     * A command should have ended control, but the mode does not show it. The motors show whether the robot has received
     * the command: if so, it is working.
     */
    private void confirm(Command command) {
        if (estimate.isAtWork() && !halted) {
            // It may be executing a command garbled by lost bytes; stop it. A robot that works by itself ignores this.
            halted = true;
            withControl.restart();
            connection.completeWhateverIsPending();
            connection.trySend(new ActuatorCommand.DriveDirect(0, 0));
        } else if (estimate.isAtWork() && withControl.hasLasted(CONFIRM_FRAMES)) {
            unconfirmed = null;
            LOG.warn(
                    "{}: the robot works by itself, but its mode says that it is under control. It may report its mode one "
                            + "too high: try --mode-offset 1, or leave the option out",
                    connection.description());
        } else if (withControl.hasLasted(CONFIRM_FRAMES) && estimate.isAtRest()) {
            withControl.restart();
            // The robot may have taken it for the data of an incomplete command, which a repetition would complete.
            connection.completeWhateverIsPending();
            again = command;
            againFrames = DIGEST_FRAMES;
        }
    }

    private void sendAgain() {
        Command command = again;
        if (command != null && --againFrames == 0) {
            again = null;
            connection.trySend(command);
        }
    }

    /** Whether a new user of the robot must be notified of its activity, which started before. */
    private boolean mustReport() {
        if (mayHaveMissed && engaged && ++engagedFrames == SpotWatch.QUIET_FRAMES) {
            mayHaveMissed = false;
            return !wanted && !regaining && !outOfSight;
        }
        return false;
    }

    /**
     * Takes control again if the robot has left Safe mode by itself, for example because it was lifted; repeats the
     * command, which may be lost on a noisy line. On its dock the robot never obeys, but the attempts have switched it
     * on; then this returns true.
     */
    private boolean takeBack(Telemetry now, long nowNanos) {
        SensorValues values = now.values();
        boolean docked = values.value(Packet.CHARGING_SOURCES) != 0;
        boolean mayTake = (regaining || wanted) && !outOfSight && !now.isUnderControl() && !values.anyWheelDrop();
        if (!mayTake) {
            withoutControl.restart();
            tries = 0;
            return false;
        }
        withoutControl.count(nowNanos);
        if (!withoutControl.hasLasted(SpotWatch.QUIET_FRAMES)) {
            return false;
        }
        withoutControl.restart();
        tries++;
        boolean over = docked && tries > TRIES_ON_DOCK;
        boolean switchedOn = over && regaining;
        if (over) {
            regaining = false;
        } else if (tries % 2 == 0) {
            connection.completeWhateverIsPending();
        } else {
            connection.trySend(new Command.Safe());
        }
        return switchedOn;
    }
}
