package org.evoloop.device;

import static java.util.Objects.requireNonNull;
import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.evoloop.device.MqttImitation.Words;
import org.evoloop.imitation.Faults;
import org.evoloop.imitation.Imitation;
import org.evoloop.mqtt.Mosquitto;
import org.jspecify.annotations.Nullable;

/** The devices of {@code devices} that are imitated from what is published about them. */
enum ImitatedDevice {
    ZIGBEE_BULB("zigbee-bulb", new PublishedWords.ZigbeeBulb()),
    ROLLER_SHUTTER("roller-shutter", new PublishedWords.Shutter()),
    WASHING_MACHINE("washing-machine", new PublishedWords.Washer()),
    VALETUDO("valetudo", new PublishedWords.Valetudo()) {
        @Override
        Faults faults() {
            return CANNOT_BE_ASKED;
        }
    },
    WIFI_ROOMBA("wifi-roomba", new PublishedWords.WifiRoomba()) {
        @Override
        Faults faults() {
            return CANNOT_BE_ASKED;
        }

        @Override
        Running imitate(Path folder, Mosquitto broker, Imitation device) throws Exception {
            RobotBroker own = new RobotBroker(folder, broker);
            Running running = super.imitate(folder, broker, device);
            Files.writeString(folder.resolve("password.txt"), RobotBroker.PASSWORD);
            return running.with(own)
                    .replacing("roomba.local", "127.0.0.1:" + own.port())
                    .replacing("sha256=ask", "sha256=" + own.fingerprint())
                    .replacing("# password-file", "password-file")
                    // The test presses at any time of day.
                    .replacing("[\"08:00\", \"20:00\"]", "[\"00:00\", \"00:00\"]");
        }
    },
    AIR_CONDITIONER("air-conditioner", new PublishedWords.Meter()) {
        @Override
        Running imitate(Path folder, Mosquitto broker, Imitation device) throws Exception {
            Path socket = folder.resolve("lircd");
            return super.imitate(folder, broker, device)
                    .with(new LircImitation(socket, Map.of("KEY_POWER", "power", "KEY_TURBO", "turbo"), device))
                    .replacing("/run/lirc/lircd", socket.toString());
        }
    },
    OCTOPRINT("octoprint", null) {
        @Override
        Faults faults() {
            // What has arrived is done at once, however late it is answered.
            return new Faults(10, 0, 15, Duration.ZERO, LIMIT.multipliedBy(6).dividedBy(5));
        }

        @Override
        Set<String> raisedByFunctions() {
            return Set.of("look");
        }

        @Override
        Running imitate(Path folder, Mosquitto broker, Imitation device) throws Exception {
            OctoPrintImitation server = new OctoPrintImitation(device);
            Files.writeString(folder.resolve("key.txt"), OctoPrintImitation.KEY);
            return new Running(broker)
                    .with(server)
                    .replacing("http://octopi.local", server.address())
                    .replacing("every: 1 s", "every: 20 ms\n    within: " + LIMIT.toMillis() + " ms")
                    .replacing("every: 5 s", "every: 20 ms")
                    .replacing("# header-files", "header-files");
        }
    };

    /** The limits of the files, so that the test takes little time. */
    static final Duration LIMIT = Duration.ofMillis(300);

    /** A lost command stays in doubt until the robot does something, so none is lost. */
    private static final Faults CANNOT_BE_ASKED = new Faults(0, 5, 10, LIMIT.dividedBy(2), LIMIT.dividedBy(2));

    private final String folder;
    private final @Nullable Words words;

    /** @param words null if it has no broker */
    ImitatedDevice(String folder, @Nullable Words words) {
        this.folder = folder;
        this.words = words;
    }

    /** In {@code devices}; its converter has the same name. */
    String folder() {
        return folder;
    }

    Faults faults() {
        return new Faults(10, 10, 15, LIMIT.dividedBy(2), LIMIT.multipliedBy(6).dividedBy(5));
    }

    /** Events that no person raises. */
    Set<String> raisedByFunctions() {
        return Set.of();
    }

    /**
     * Lets it run.
     *
     * @param folder of its own
     * @param broker that of the home
     */
    Running imitate(Path folder, Mosquitto broker, Imitation device) throws Exception {
        return new Running(broker).with(new MqttImitation(broker, device, requireNonNull(words)));
    }

    /** An imitation that runs, and what its file says in the test. */
    static final class Running implements AutoCloseable {
        private final List<AutoCloseable> parts = new ArrayList<>();
        private final Map<String, String> replaced = new LinkedHashMap<>();

        Running(Mosquitto home) {
            replacing("mqtt://127.0.0.1", home.url());
        }

        Running with(AutoCloseable part) {
            parts.add(part);
            return this;
        }

        Running replacing(String text, String with) {
            replaced.put(text, with);
            return this;
        }

        /** The text of the device's file for this imitation. */
        String in(String file) {
            String text = file.replaceAll("within: [0-9]+ s", "within: " + LIMIT.toMillis() + " ms")
                    .replaceAll("steady: [0-9]+ (s|min)", "steady: 50 ms");
            for (Map.Entry<String, String> each : replaced.entrySet()) {
                assertThat(text).contains(each.getKey());
                text = text.replace(each.getKey(), each.getValue());
            }
            return text;
        }

        @Override
        public void close() throws Exception {
            for (AutoCloseable part : parts) {
                part.close();
            }
        }
    }
}
