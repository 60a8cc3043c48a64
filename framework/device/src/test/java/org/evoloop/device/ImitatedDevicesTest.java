package org.evoloop.device;

import static org.assertj.core.api.Assertions.assertThat;
import static org.awaitility.Awaitility.await;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Random;
import java.util.stream.Stream;
import org.evoloop.converter.ConverterStatus;
import org.evoloop.converter.PushMonitor;
import org.evoloop.converter.SystemEventConverter;
import org.evoloop.device.MqttImitation.Said;
import org.evoloop.device.MqttImitation.Words;
import org.evoloop.imitation.Faults;
import org.evoloop.imitation.Imitation;
import org.evoloop.loop.LoopConfig;
import org.evoloop.mqtt.Mosquitto;
import org.evoloop.statemachine.StateMachine;
import org.evoloop.statemachine.Transition;
import org.evoloop.time.SystemClock;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/**
 * The devices at a broker, each imitated from its published interface: they lose commands, answer and obey late, and act by
 * themselves. After each press the record is what the device's own log says, or in doubt; no command is sent that does
 * nothing.
 */
class ImitatedDevicesTest {
    private static final Path DEVICES = Path.of(System.getProperty("evoloop.root", "../.."), "devices");
    private static final Duration PATIENCE = Duration.ofSeconds(60);
    private static final Duration LIMIT = Duration.ofMillis(300);

    @TempDir
    private Path folder;

    /** The devices, with what their makers publish. */
    enum Device implements Words {
        ZIGBEE_BULB("zigbee-bulb") {
            @Override
            public Said present() {
                return new Said("zigbee2mqtt/bulb/availability", "{\"state\":\"online\"}");
            }

            @Override
            public Optional<String> command(Said message) {
                return message.topic().equals("zigbee2mqtt/bulb/set")
                        ? Optional.of(message.payload().contains("ON") ? "turn on" : "turn off")
                        : Optional.empty();
            }

            @Override
            public boolean asks(Said message) {
                return message.topic().equals("zigbee2mqtt/bulb/get");
            }

            @Override
            public List<Said> reports(String state) {
                return List.of(new Said(
                        "zigbee2mqtt/bulb",
                        "{\"brightness\":254,\"linkquality\":90,\"state\":\"" + (state.equals("On") ? "ON" : "OFF")
                                + "\"}"));
            }
        },
        ROLLER_SHUTTER("roller-shutter") {
            private static final Map<String, String> COMMANDS =
                    Map.of("open", "open", "close", "close", "stop", "stop", "pos,10", "to gap", "pos,50", "to sun");
            private static final Map<String, String> STATES = Map.of(
                    "Open", "\"state\":\"open\",\"current_pos\":100",
                    "Closed", "\"state\":\"closed\",\"current_pos\":0",
                    "Between", "\"state\":\"stopped\",\"current_pos\":73",
                    "Gap", "\"state\":\"stopped\",\"current_pos\":10",
                    "Sun", "\"state\":\"stopped\",\"current_pos\":51",
                    "Opening", "\"state\":\"opening\",\"current_pos\":20,\"target_pos\":100",
                    "Closing", "\"state\":\"closing\",\"current_pos\":20,\"target_pos\":0",
                    "ToGap", "\"state\":\"closing\",\"current_pos\":80,\"target_pos\":10",
                    "ToSun", "\"state\":\"opening\",\"current_pos\":30,\"target_pos\":50");

            @Override
            public Said present() {
                return new Said("shutter/online", "true");
            }

            @Override
            public Optional<String> command(Said message) {
                return message.topic().equals("shutter/command/cover:0")
                        ? Optional.ofNullable(COMMANDS.get(message.payload()))
                        : Optional.empty();
            }

            @Override
            public boolean asks(Said message) {
                return message.topic().equals("shutter/command")
                        && message.payload().equals("status_update");
            }

            @Override
            public List<Said> reports(String state) {
                return List.of(new Said(
                        "shutter/status/cover:0",
                        "{\"id\":0,\"source\":\"mqtt\"," + STATES.get(state)
                                + ",\"apower\":12.5,\"pos_control\":true}"));
            }
        },
        WASHING_MACHINE("washing-machine") {
            @Override
            public Said present() {
                return new Said("tele/washer/LWT", "Online");
            }

            @Override
            public Optional<String> command(Said message) {
                return message.topic().equals("cmnd/washer/POWER")
                        ? Optional.of(message.payload().equals("ON") ? "switch on" : "switch off")
                        : Optional.empty();
            }

            @Override
            public boolean asks(Said message) {
                return message.topic().equals("cmnd/washer/Status");
            }

            @Override
            public List<Said> reports(String state) {
                double power = state.equals("Running") ? 412.5 : state.equals("Standby") ? 1.2 : 0;
                return List.of(
                        new Said("stat/washer/POWER", state.equals("Off") ? "OFF" : "ON"),
                        new Said("tele/washer/SENSOR", "{\"ENERGY\":{\"Total\":3.1,\"Power\":" + power + "}}"),
                        new Said(
                                "stat/washer/STATUS8",
                                "{\"StatusSNS\":{\"ENERGY\":{\"Total\":3.1,\"Power\":" + power + "}}}"));
            }
        },
        VALETUDO("valetudo") {
            @Override
            public Said present() {
                return new Said("valetudo/robot/$state", "ready");
            }

            @Override
            public Optional<String> command(Said message) {
                return switch (message.topic()) {
                    case "valetudo/robot/BasicControlCapability/operation/set" ->
                        Optional.of(message.payload().toLowerCase(Locale.ROOT));
                    case "valetudo/robot/ZoneCleaningCapability/start/set" -> Optional.of("spot");
                    default -> Optional.empty();
                };
            }

            @Override
            public boolean asks(Said message) {
                return false;
            }

            @Override
            public List<Said> reports(String state) {
                return List.of(new Said("valetudo/robot/StatusStateAttribute/status", state.toLowerCase(Locale.ROOT)));
            }

            @Override
            Faults faults() {
                // It cannot be asked, so a lost command stays in doubt until the robot does something.
                return new Faults(0, 5, 10, LIMIT.dividedBy(2), LIMIT.dividedBy(2));
            }
        };

        private final String folder;

        Device(String folder) {
            this.folder = folder;
        }

        Faults faults() {
            return new Faults(
                    10, 10, 15, LIMIT.dividedBy(2), LIMIT.multipliedBy(6).dividedBy(5));
        }
    }

    @ParameterizedTest
    @EnumSource
    void aFewPresses(Device device) throws Exception {
        press(device, 20, 11);
    }

    @ParameterizedTest
    @EnumSource
    @Tag("slow")
    void fiveHundredPresses(Device device) throws Exception {
        press(device, 500, Long.getLong("evoloop.seed", new Random().nextLong()));
    }

    private void press(Device device, int presses, long seed) throws Exception {
        try (Mosquitto broker = new Mosquitto(folder).start();
                SystemClock clock = new SystemClock();
                SystemEventConverter converter = new SystemEventConverter(LoopConfig.defaults(device.folder, clock))) {
            DeviceFile file = read(device, broker);
            Imitation imitation = new Imitation(file.models().original(), device.faults(), seed);
            PushMonitor wall = new PushMonitor("Wall");
            converter.addMonitor(wall);
            List<Parts> parts = new ArrayList<>();
            file.guards().attach(clock, Wiring.add(file, converter, parts::add));
            converter.addKnowledge(file.knowledge(file.models()));
            converter.build();
            try (MqttImitation there = new MqttImitation(broker, imitation, device)) {
                for (Parts each : parts) {
                    each.open().open();
                }
                converter.start();
                await().atMost(PATIENCE)
                        .until(() -> converter.status().link() != null
                                && converter.status().link().up());
                imitation.ask();
                await().atMost(PATIENCE).until(() -> agrees(converter, imitation));
                operate(converter, wall, imitation, new Random(seed), presses);
            } catch (AssertionError | RuntimeException failed) {
                throw new AssertionError("seed " + seed + ", " + converter.history() + "\n" + imitation.log(), failed);
            } finally {
                parts.forEach(each -> each.close().run());
            }
            assertThat(imitation.log())
                    .as("a command that does nothing was not meant")
                    .noneMatch(line -> line.startsWith("ignores"));
            System.out.println(device.folder + ", " + presses + " presses, seed " + seed + ": "
                    + imitation.logged("loses") + " commands lost, " + imitation.logged("obeys") + " obeyed");
        }
    }

    private static void operate(
            SystemEventConverter converter, PushMonitor wall, Imitation imitation, Random random, int presses) {
        for (int press = 0; press < presses; press++) {
            if (random.nextInt(3) == 0) {
                imitation.act();
            } else {
                List<String> possible = possible(converter);
                if (!possible.isEmpty()) {
                    wall.submit(possible.get(random.nextInt(possible.size()))).join();
                    ConverterStatus after = converter.status();
                    if (after.doubt().isEmpty()) {
                        assertThat(after.states().original().name()).isEqualTo(imitation.truth());
                    }
                }
            }
            await().atMost(PATIENCE).pollInterval(Duration.ofMillis(5)).until(() -> agrees(converter, imitation));
        }
    }

    /** What a person can do now: the events that the new model has there, and that are not the device's own. */
    private static List<String> possible(SystemEventConverter converter) {
        StateMachine evolved = converter.knowledge().models().evolved();
        StateMachine original = converter.knowledge().models().original();
        return evolved.transitionsFrom(converter.status().states().evolved()).stream()
                .map(Transition::event)
                .map(event -> event.trigger().name())
                .filter(event -> original.spontaneous().stream()
                        .noneMatch(own -> own.name().equals(event)))
                .filter(event -> !event.startsWith("tm("))
                .distinct()
                .sorted()
                .toList();
    }

    private static boolean agrees(SystemEventConverter converter, Imitation imitation) {
        ConverterStatus status = converter.status();
        return status.doubt().isEmpty()
                && status.events().waiting() + status.events().inProgress() == 0
                && status.states().original().name().equals(imitation.truth());
    }

    private DeviceFile read(Device device, Mosquitto broker) throws IOException {
        Path from = DEVICES.resolve(device.folder);
        Files.writeString(folder.resolve("README.md"), Files.readString(from.resolve("README.md")));
        String text = Files.readString(from.resolve(device.folder + ".yaml"))
                .replace("mqtt://127.0.0.1", broker.url())
                .replaceAll("within: [0-9]+ s", "within: " + LIMIT.toMillis() + " ms")
                .replaceAll("steady: [0-9]+ min", "steady: 50 ms");
        assertThat(Stream.of(text.split("\n"))).anyMatch(line -> line.contains(broker.url()));
        return DeviceFile.read(
                Files.writeString(folder.resolve(device.folder + ".yaml"), text), DeviceProgram.options());
    }
}
