package org.evoloop.fleet;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.evoloop.fleet.wire.ModelRecord;

/** The project's models as records. */
public final class Models {
    /** The lamp whose second light comes on with two presses within 2 s. */
    public static final ModelRecord LAMP = lamp(2_000);

    /** The same lamp, with another time for the second press. */
    public static ModelRecord lamp(long millis) {
        String file = "models/light-bulb.xml";
        List<ModelRecord.Timer> timers = List.of(new ModelRecord.Timer("wait", "timeout", millis));
        return new ModelRecord(file, text(file), "original", "new", timers, 8);
    }

    /** The paper's cleaning robot; a function at the robot determines how long it waits for a second press. */
    public static final ModelRecord ROBOT = new ModelRecord(
            "models/cleaning-robot.xml", text("models/cleaning-robot.xml"), "original", "new", List.of(), 8);

    private Models() {}

    private static String text(String file) {
        try {
            return Files.readString(Path.of(System.getProperty("evoloop.root", ".."), file));
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }
}
