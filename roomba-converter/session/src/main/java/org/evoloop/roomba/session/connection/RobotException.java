package org.evoloop.roomba.session.connection;

/**
 * The cable works, but the robot at its other end does not respond as required. The message is written for its owner:
 * it names the port, what is wrong and how to fix it, and needs no stack trace.
 *
 * @since 0.1
 */
public final class RobotException extends RuntimeException {
    /** @param message the problem, for the robot's owner */
    public RobotException(String message) {
        super(message);
    }
}
