package org.evoloop.device.file;

/**
 * A device file cannot be used as it is. The message is for the person who wrote it: each of its lines names the file,
 * the line, what is wrong, and how to fix it.
 *
 * @since 0.1
 */
public final class DeviceFileException extends RuntimeException {

    /** @param message see above */
    public DeviceFileException(String message) {
        super(message);
    }
}
