package org.evoloop.roomba.simulator;

import java.io.IOException;

/**
 * The cable between the robot and its client, which can be unplugged and plugged in again. The robot is not affected.
 *
 * @since 0.1
 */
public interface Cable {
    /**
     * Unplugs the cable: the client sees a hang-up.
     *
     * @throws IllegalArgumentException if it is unplugged already
     */
    void unplug();

    /**
     * Plugs the cable in again: clients can open the port under the same path as before.
     *
     * @throws IllegalArgumentException if it is plugged in already
     * @throws IOException if the system cannot make the port
     */
    void replug() throws IOException;
}
