package org.evoloop.device;

import org.evoloop.device.file.Section;

/**
 * A kind of connection that a device file can have, found by {@link java.util.ServiceLoader}.
 *
 * <p>Threading: used by the thread that reads the file.
 *
 * @since 0.1
 */
public interface ConnectionKind {
    /** The key by which a connection of this kind is recognized, such as {@code lines}; its value is the address. */
    String key();

    /**
     * Reads a connection; nothing is opened yet. Mistakes go to {@link Section#problems}; a key that is not asked for
     * is one.
     *
     * @param name of the connection in the file, for messages
     */
    Connection read(String name, Section section, FileModels models);
}
