package org.evoloop.device.connection;

import org.evoloop.device.Connection;
import org.evoloop.device.ConnectionKind;
import org.evoloop.device.FileModels;
import org.evoloop.device.file.Section;

/**
 * {@code http: http://HOST}: a device that answers HTTP requests.
 *
 * <p>Threading: as {@link ConnectionKind}.
 *
 * @since 0.1
 */
public final class HttpKind implements ConnectionKind {
    /** For {@link java.util.ServiceLoader}. */
    public HttpKind() {}

    @Override
    public String key() {
        return "http";
    }

    @Override
    public Connection read(String name, Section section, FileModels models) {
        return HttpFileConnection.read(name, section, models);
    }
}
