package org.evoloop.device.connection;

import org.evoloop.device.Connection;
import org.evoloop.device.ConnectionKind;
import org.evoloop.device.FileModels;
import org.evoloop.device.file.Section;

/**
 * {@code mqtt: mqtt://HOST}: a device or a controller behind an MQTT broker.
 *
 * <p>Threading: as {@link ConnectionKind}.
 *
 * @since 0.1
 */
public final class MqttKind implements ConnectionKind {
    /** For {@link java.util.ServiceLoader}. */
    public MqttKind() {}

    @Override
    public String key() {
        return "mqtt";
    }

    @Override
    public Connection read(String name, Section section, FileModels models) {
        return MqttFileConnection.read(name, section, models);
    }
}
