package org.evoloop.roomba;

import org.evoloop.device.Connection;
import org.evoloop.device.ConnectionKind;
import org.evoloop.device.FileModels;
import org.evoloop.device.file.Section;

/**
 * {@code roomba: /dev/ttyUSB0}: a Roomba at a serial port. It knows by their names which events and states of the models
 * are the robot's, so a file need not say how they are sent.
 *
 * <p>Threading: as {@link ConnectionKind}.
 */
public final class RoombaKind implements ConnectionKind {
    /** For {@link java.util.ServiceLoader}. */
    public RoombaKind() {}

    @Override
    public String key() {
        return "roomba";
    }

    @Override
    public Connection read(String name, Section section, FileModels models) {
        return RoombaFileConnection.read(name, section, models);
    }
}
