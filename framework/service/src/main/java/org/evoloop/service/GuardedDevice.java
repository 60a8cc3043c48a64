package org.evoloop.service;

/**
 * A device that continues its last command when it gets no new ones, such as a robot that drives. A {@link DeviceGuard}
 * makes it safe when this process has ended or is not running.
 *
 * <p>Threading: called on a thread of the guard's, one call at a time.
 *
 * @since 0.1
 */
public interface GuardedDevice {
    /**
     * What makes the device safe, as a command of the POSIX shell that needs nothing of this process. Its exit status
     * tells whether it has succeeded; if not, it is repeated for some seconds. It may run although the device is safe
     * already.
     */
    String makeSafeCommand();

    /**
     * Whether the device would be unsafe if this process stood still from now on. A device of which this is true is
     * made safe also if the call does not return within {@link DeviceGuard#LIMIT}.
     */
    boolean isActive();

    /**
     * The device has been made safe, or is about to be, since this process stood still: nothing that was decided before
     * may go on. Until this returns, {@link DeviceGuard#mayTell} is false.
     *
     * @param reason for people
     */
    void madeSafe(String reason);
}
