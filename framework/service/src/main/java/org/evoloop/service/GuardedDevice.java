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
     * The command of the POSIX shell that makes the device safe. It must not depend on this process. A non-zero exit
     * status means failure; then it is repeated for a few seconds. It may run although the device is already safe.
     */
    String makeSafeCommand();

    /**
     * Whether the device would be unsafe if this process stopped running now. While it is, the device is also made safe
     * if a call of this method does not return within {@link DeviceGuard#LIMIT}.
     */
    boolean isActive();

    /**
     * Called when the device has been made safe, or is about to be, because this process stopped running. Anything
     * decided before must be cancelled. Until this returns, {@link DeviceGuard#maySend} is false.
     *
     * @param reason for people
     */
    void madeSafe(String reason);
}
