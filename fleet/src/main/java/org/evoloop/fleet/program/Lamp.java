package org.evoloop.fleet.program;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.util.List;
import org.evoloop.fleet.stream.FleetException;
import org.evoloop.fleet.wire.ModelRecord;

/**
 * The models of the lamp whose second light comes on with two presses.
 *
 * @since 0.1
 */
public final class Lamp {
    private Lamp() {}

    /**
     * The lamp that waits this long for the second press.
     *
     * @throws FleetException if its file does not exist
     */
    public static ModelRecord waiting(long millis) {
        Path file = Path.of(System.getProperty("evoloop.home", "."), "models", "light-bulb.xml");
        try {
            List<ModelRecord.Timer> timers = List.of(new ModelRecord.Timer("wait", "timeout", millis));
            return new ModelRecord(
                    "light-bulb.xml", Files.readString(file), "original", "new", timers, ModelRecord.QUEUE);
        } catch (NoSuchFileException e) {
            throw new FleetException("the file of the lamp's models is missing: " + file);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }
}
