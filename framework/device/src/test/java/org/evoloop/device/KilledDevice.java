package org.evoloop.device;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.List;
import java.util.concurrent.CountDownLatch;
import org.evoloop.imitation.Faults;
import org.evoloop.imitation.Imitation;
import org.evoloop.mqtt.Gateway;

/** The device of a device file, behind its gateway, in a process of its own. Each start is in the first state, as after a power cut. */
final class KilledDevice {
    private KilledDevice() {}

    /** @param arguments the device file, the broker's port, the device's topic, and the file to which its log is appended */
    public static void main(String... arguments) throws Exception {
        Path log = Path.of(arguments[3]);
        Imitation device = new Imitation(
                        DeviceFile.read(Path.of(arguments[0]), DeviceProgram.options())
                                .models()
                                .original(),
                        Faults.NONE,
                        0)
                .recordingTo(line -> append(log, line));
        device.restart();
        try (Gateway gateway = new Gateway(Integer.parseInt(arguments[1]), arguments[2], device)) {
            new CountDownLatch(1).await();
        }
    }

    private static void append(Path log, String line) {
        try {
            Files.write(log, List.of(line), StandardOpenOption.CREATE, StandardOpenOption.APPEND);
        } catch (IOException failure) {
            throw new UncheckedIOException(failure);
        }
    }
}
