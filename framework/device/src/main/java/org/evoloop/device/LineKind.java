package org.evoloop.device;

import org.evoloop.device.file.Section;

/**
 * {@code lines: tcp://HOST:PORT}: a device or a controller that exchanges lines of text.
 *
 * @since 0.1
 */
public final class LineKind implements ConnectionKind {
    /** For {@link java.util.ServiceLoader}. */
    public LineKind() {}

    @Override
    public String key() {
        return "lines";
    }

    @Override
    public Connection read(String name, Section section, FileModels models) {
        return LineFileConnection.read(name, section, models);
    }
}
