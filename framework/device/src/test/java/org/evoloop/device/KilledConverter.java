package org.evoloop.device;

import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;

/** The converter of a device file in a process of its own. */
final class KilledConverter {
    private KilledConverter() {}

    public static void main(String... arguments) {
        List<String> options = Arrays.asList(arguments).subList(1, arguments.length);
        System.exit(DeviceProgram.run(Path.of(arguments[0]), options));
    }
}
