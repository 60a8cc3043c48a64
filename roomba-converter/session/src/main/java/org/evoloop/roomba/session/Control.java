package org.evoloop.roomba.session;

import org.evoloop.roomba.oi.ActuatorCommand;
import org.evoloop.roomba.oi.Command;
import org.evoloop.roomba.oi.Packet;
import org.evoloop.roomba.oi.SensorValues;
import org.evoloop.roomba.session.connection.Connection;
import org.evoloop.roomba.session.inference.ActivityEstimate;
import org.evoloop.roomba.session.inference.SpotWatch;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Sees to it that the robot is under control, or left alone, as its user wants it: control that the robot gives up is
 * taken again, a command that got lost is sent again, and a robot that was out of sight is stopped.
 *
 * <p>Threading: not thread-safe, but the methods {@code is...} may be called from any thread.
 */
final class Control {
    private static final Logger LOG = LoggerFactory.getLogger(RoombaSession.class);

    /** So many frames after it came back into sight it is plain what the robot does. */
    private static final int SETTLING_FRAMES = 4;

    /**
     * A command that ends control shows within a few frames, in the mode; if not there, its motors must have begun by
     * now. It must not be sent twice if it has arrived: the second Clean ends what the first began.
     */
    static final int CONFIRM_FRAMES = ActivityEstimate.START_FRAMES;

    /**
     * What completes a pending command is on the line for 45 ms, and a robot needs 20 ms to digest a change of its
     * mode.
     */
    private static final int DIGEST_FRAMES = 6;

    /** Three Safe commands, with whatever was pending completed between. */
    private static final int TRIES_ON_DOCK = 5;

    /** What a frame has shown of the robot. */
    enum Known {
        NOTHING,
        /** It is on and does nothing, whatever it was taken to do. */
        ON,
        /** It does what it is taken to do. */
        AS_ESTIMATED
    }

    private final Connection connection;
    private final ActivityEstimate estimate;
    private boolean engaged;
    private volatile boolean wanted;
    private volatile boolean regaining;
    private @Nullable Command unconfirmed;
    private boolean halted;
    private @Nullable Command again;
    private int againFrames;
    private boolean outOfSight;
    private int settlingFrames;
    private boolean mayHaveMissed = true;
    private int engagedFrames;
    private boolean underControl;
    private int framesWith;
    private int framesWithout;

    Control(Connection connection, ActivityEstimate estimate) {
        this.connection = connection;
        this.estimate = estimate;
    }

    /** Control is wanted now, and again whenever the robot has left Safe mode by itself. */
    void want() {
        wanted = true;
        engaged = true;
    }

    /** The robot is to be left to itself for now; if it comes back from out of sight, control is taken. */
    void leaveAlone() {
        wanted = false;
        engaged = true;
    }

    /** The robot is to be left to itself for good. */
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

    /** The last command is not sent again, whatever became of it. */
    void forgetCommand() {
        unconfirmed = null;
        again = null;
    }

    /** Whether control is wanted now. */
    boolean isWanted() {
        return wanted;
    }

    /** Whether the robot has just come back into sight and is about to be stopped. */
    boolean isRegaining() {
        return regaining;
    }

    /** A command has been sent. */
    void commanded(Command command) {
        if (engaged) {
            // Who commands the robot makes it do what it is taken to do; frames that are on their way tell older
            // things.
            mayHaveMissed = false;
        }
        unconfirmed = null;
        halted = false;
        again = null;
        if (command.opcode().endsControl()) {
            unconfirmed = underControl ? command : null;
            // Counted anew: the frames that are on their way still show control.
            framesWith = 0;
        }
    }

    /** The robot is out of sight; what it does meanwhile nobody knows. */
    void loseSight() {
        outOfSight = true;
        settlingFrames = SETTLING_FRAMES;
    }

    /** Takes the next frame; returns what has become known of the robot. */
    Known update(Telemetry now) {
        sendAgain();
        comeBackIntoSight();
        boolean on = seeControl(now.isUnderControl());
        boolean owed = isTellingOwed();
        on |= takeBack(now);
        return on ? Known.ON : owed ? Known.AS_ESTIMATED : Known.NOTHING;
    }

    /**
     * The robot is back. What its owner did to it meanwhile cannot be told from what it shows: cleaning and spot
     * cleaning look alike. So as soon as it is to be controlled at all, control is taken, which ends whatever it does;
     * then it is on.
     */
    private void comeBackIntoSight() {
        if (outOfSight && engaged && --settlingFrames <= 0) {
            outOfSight = false;
            regaining = true;
            connection.trySend(new Command.Safe());
            connection.trySend(new ActuatorCommand.DriveDirect(0, 0));
        }
    }

    /** Returns whether it is known that the robot does nothing. */
    private boolean seeControl(boolean now) {
        if (now && !underControl) {
            // Only when it begins: a command that ends control takes some frames to show.
            estimate.controlled();
        }
        underControl = now;
        boolean on = underControl && regaining;
        regaining &= !on;
        Command command = unconfirmed;
        framesWith = underControl ? framesWith + 1 : 0;
        if (!underControl) {
            unconfirmed = null;
        } else if (command != null) {
            confirm(command);
        } else {
            // Still under control though it was released, and at rest: it is on.
            on |= engaged && !wanted && framesWith % SpotWatch.QUIET_FRAMES == 0 && estimate.isAtRest();
        }
        return on;
    }

    /**
     * A command should have ended control, and the mode does not show that. What became of it only the motors can tell:
     * the robot is at work, or it has not received it.
     */
    private void confirm(Command command) {
        if (estimate.isAtWork() && !halted) {
            // It may drive by what commands have become of which a part was lost. One that works by itself takes no
            // notice.
            halted = true;
            framesWith = 0;
            connection.completeWhateverIsPending();
            connection.trySend(new ActuatorCommand.DriveDirect(0, 0));
        } else if (estimate.isAtWork() && framesWith >= CONFIRM_FRAMES) {
            unconfirmed = null;
            LOG.warn(
                    "{}: the robot works by itself, but its mode says that it is under control. It may report its mode one "
                            + "too high: try --mode-offset 1, or leave the option out",
                    connection.description());
        } else if (framesWith >= CONFIRM_FRAMES && estimate.isAtRest()) {
            framesWith = 0;
            // It may have been taken for the data of a command of which a part was lost, and one more would complete
            // that.
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

    /** Who engages with the robot has not heard what it did before, though it was in sight. */
    private boolean isTellingOwed() {
        if (mayHaveMissed && engaged && ++engagedFrames == SpotWatch.QUIET_FRAMES) {
            mayHaveMissed = false;
            return !wanted && !regaining && !outOfSight;
        }
        return false;
    }

    /**
     * The robot leaves Safe mode by itself, for instance when it is lifted, and a command may be lost on a noisy line:
     * it is taken back, tried again until it obeys. On its dock it never does; but so many tries have switched it on,
     * which is told by true.
     */
    private boolean takeBack(Telemetry now) {
        SensorValues values = now.values();
        boolean docked = values.value(Packet.CHARGING_SOURCES) != 0;
        boolean mayTake = (regaining || wanted) && !outOfSight && !now.isUnderControl() && !values.anyWheelDrop();
        framesWithout = mayTake ? framesWithout + 1 : 0;
        int tries = framesWithout / SpotWatch.QUIET_FRAMES;
        if (tries == 0 || framesWithout % SpotWatch.QUIET_FRAMES != 0) {
            return false;
        }
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
