package org.evoloop.xmi.dialect;

import java.io.BufferedInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.nio.file.AccessDeniedException;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import org.evoloop.statemachine.ModelException;

/**
 * The bytes of a model file, whose beginning tells its format.
 *
 * <p>Threading: for one thread.
 */
public final class ModelInput {
    private final String file;
    private final BufferedInputStream bytes;
    private final byte[] head;

    private ModelInput(String file, BufferedInputStream bytes, byte[] head) {
        this.file = file;
        this.bytes = bytes;
        this.head = head;
    }

    /**
     * Opens a file.
     *
     * @throws ModelException if it cannot be opened
     */
    public static ModelInput open(Path file) {
        if (Files.isDirectory(file)) {
            throw new ModelException(file + ": is a directory; name a file in it");
        }
        // Reading a pipe may block forever, and a device may never end.
        if (Files.exists(file) && !Files.isRegularFile(file)) {
            throw new ModelException(file + ": is a pipe or a device; save the model in a file and name that");
        }
        try {
            return of(file.toString(), ZippedModel.unpacked(file));
        } catch (NoSuchFileException missing) {
            throw new ModelException(file + ": does not exist; correct the path", missing);
        } catch (AccessDeniedException denied) {
            throw new ModelException(file + ": cannot be read: permission denied; grant read permission", denied);
        } catch (IOException unreadable) {
            throw unreadable(file.toString(), unreadable);
        }
    }

    /**
     * Takes ownership of {@code bytes}, which whoever reads them to the end closes.
     *
     * @throws ModelException if they cannot be read
     */
    public static ModelInput of(String file, InputStream bytes) {
        BufferedInputStream buffered = new BufferedInputStream(bytes);
        try {
            buffered.mark(ForeignFormat.HEAD_BYTES);
            byte[] head = buffered.readNBytes(ForeignFormat.HEAD_BYTES);
            buffered.reset();
            return new ModelInput(file, buffered, head);
        } catch (IOException unreadable) {
            throw unreadable(file, unreadable);
        }
    }

    private static ModelException unreadable(String file, IOException cause) {
        return new ModelException(file + ": cannot be read (" + cause.getMessage() + ")", cause);
    }

    /** The file's name, for messages. */
    public String file() {
        return file;
    }

    /** The first bytes, up to 16 KiB, which {@link #bytes} holds, too. */
    public byte[] head() {
        return head.clone();
    }

    /** All bytes, from the first one. */
    public InputStream bytes() {
        return bytes;
    }

    /**
     * All bytes, and closes the input.
     *
     * @param most how many may be kept in memory
     * @throws ModelException if there are more, or they cannot be read
     */
    public byte[] all(int most) {
        try (bytes) {
            byte[] all = bytes.readNBytes(most + 1);
            if (all.length > most) {
                throw new ModelException(
                        file + ": is larger than " + (most >> 20) + " MiB: split it, or keep its models in XMI");
            }
            return all;
        } catch (IOException unreadable) {
            throw unreadable(file, unreadable);
        }
    }
}
