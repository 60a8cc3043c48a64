package org.evoloop.device.connection;

import org.evoloop.device.Connection;
import org.evoloop.device.ConnectionKind;
import org.evoloop.device.FileModels;
import org.evoloop.device.file.Section;

/**
 * {@code home-assistant: http://homeassistant.local:8123}: a device or a controller that is an entity of Home Assistant.
 *
 * <p>Threading: as {@link ConnectionKind}.
 *
 * @since 0.1
 */
public final class HomeAssistantKind implements ConnectionKind {
    /** For {@link java.util.ServiceLoader}. */
    public HomeAssistantKind() {}

    @Override
    public String key() {
        return "home-assistant";
    }

    @Override
    public Connection read(String name, Section section, FileModels models) {
        return HomeFileConnection.read(name, section, models);
    }
}
