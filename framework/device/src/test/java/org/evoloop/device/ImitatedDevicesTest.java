package org.evoloop.device;

import static org.assertj.core.api.Assertions.assertThat;
import static org.awaitility.Awaitility.await;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.evoloop.converter.ConverterStatus;
import org.evoloop.converter.HistoryEntry;
import org.evoloop.converter.PushMonitor;
import org.evoloop.converter.SystemEventConverter;
import org.evoloop.evolution.EventOutcome;
import org.evoloop.imitation.Imitation;
import org.evoloop.loop.LoopConfig;
import org.evoloop.mqtt.Mosquitto;
import org.evoloop.statemachine.State;
import org.evoloop.statemachine.StateMachine;
import org.evoloop.statemachine.Transition;
import org.evoloop.time.SystemClock;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/**
 * The devices, each imitated from its published interface: they lose commands, answer and obey late, restart, and act by
 * themselves. After each press the record is what the device's own log says, or in doubt; no command is sent that does
 * nothing; and the device does what its owner wants. One that cannot be asked where it is leaves a doubt when it has lost a
 * command, until it reports something.
 */
@SuppressWarnings("NullAway.Init") // set before all tests
class ImitatedDevicesTest {
    private static final Path DEVICES = Path.of(System.getProperty("evoloop.root", "../.."), "devices");
    private static final Duration PATIENCE = Duration.ofSeconds(60);
    private static final int RESTARTS_IN = 60;

    @TempDir
    private static Path home;

    private static Mosquitto broker;

    @TempDir
    private Path folder;

    /** What is the same for all devices: the broker of the home, and what the first device file of a process takes. */
    @BeforeAll
    static void startBroker() {
        broker = new Mosquitto(home).start();
        for (ImitatedDevice device : ImitatedDevice.values()) {
            DeviceFile.read(path(device), DeviceProgram.options());
        }
    }

    @AfterAll
    static void stopBroker() {
        broker.close();
    }

    @ParameterizedTest
    @EnumSource
    void aFewPresses(ImitatedDevice device) throws Exception {
        press(device, 20, 11);
    }

    @ParameterizedTest
    @EnumSource
    @Tag("slow")
    void fiveHundredPresses(ImitatedDevice device) throws Exception {
        press(device, 500, Long.getLong("evoloop.seed", new Random().nextLong()));
    }

    private void press(ImitatedDevice device, int presses, long seed) throws Exception {
        StateMachine original =
                DeviceFile.read(path(device), DeviceProgram.options()).models().original();
        try (SystemClock clock = new SystemClock();
                SystemEventConverter converter = new SystemEventConverter(LoopConfig.defaults(device.folder(), clock));
                Imitation imitation = new Imitation(original, device.faults(), seed);
                ImitatedDevice.Running running = device.imitate(folder, broker, imitation)) {
            DeviceFile file = read(device, running);
            PushMonitor wall = new PushMonitor("Wall");
            converter.addMonitor(wall);
            List<Parts> parts = new ArrayList<>();
            file.guards().attach(clock, Wiring.add(file, converter, parts::add));
            converter.addKnowledge(file.knowledge(file.models()));
            converter.build();
            try {
                for (Parts each : parts) {
                    each.open().open();
                }
                converter.start();
                await().atMost(PATIENCE)
                        .until(() -> converter.status().link() != null
                                && converter.status().link().up());
                imitation.ask();
                await().atMost(PATIENCE).until(() -> agrees(converter, imitation));
                operate(device, converter, wall, imitation, new Random(seed), presses);
                imitation.ask();
                await().atMost(PATIENCE).until(() -> agrees(converter, imitation));
            } catch (AssertionError | RuntimeException failed) {
                List<HistoryEntry> history = converter.history();
                throw new AssertionError(
                        "seed " + seed + ", " + converter.status() + "\n"
                                + history.subList(Math.max(0, history.size() - 10), history.size()) + "\n"
                                + imitation.log(),
                        failed);
            } finally {
                parts.forEach(each -> each.close().run());
            }
            assertThat(inVain(imitation.log()))
                    .as("commands that did nothing were not meant")
                    .isEmpty();
            System.out.println(device.folder() + ", " + presses + " presses, seed " + seed + ": "
                    + imitation.logged("loses") + " commands lost, " + imitation.logged("obeys") + " obeyed");
        }
    }

    private static void operate(
            ImitatedDevice device,
            SystemEventConverter converter,
            PushMonitor wall,
            Imitation imitation,
            Random random,
            int presses) {
        for (int press = 0; press < presses; press++) {
            int chance = random.nextInt(RESTARTS_IN);
            if (chance == 0) {
                imitation.restart();
            } else if (chance % 3 == 0) {
                imitation.act();
            } else {
                List<String> possible = possible(converter);
                possible.removeAll(device.raisedByFunctions());
                if (!possible.isEmpty()) {
                    press(possible.get(random.nextInt(possible.size())), converter, wall, imitation);
                }
            }
            await().atMost(PATIENCE)
                    .pollInterval(Duration.ofMillis(5))
                    .until(() -> agrees(converter, imitation)
                            || !device.canBeAsked() && hasJustLost(imitation) && isInDoubt(converter));
        }
    }

    /** What is handled without a doubt has brought the device where the owner wants it. */
    private static void press(String event, SystemEventConverter converter, PushMonitor wall, Imitation imitation) {
        StateMachine evolved = converter.knowledge().models().evolved();
        EventOutcome outcome = wall.submit(event).join();
        ConverterStatus after = converter.status();
        if (after.doubt().isEmpty() && after.events().inProgress() == 0) {
            assertThat(imitation.truth()).isEqualTo(after.states().original().name());
        }
        if (outcome instanceof EventOutcome.Handled handled && after.doubt().isEmpty()) {
            List<State> wanted = evolved.transitionsFrom(handled.from().evolved()).stream()
                    .filter(transition -> transition.event().trigger().name().equals(event))
                    .map(Transition::target)
                    .toList();
            assertThat(wanted).as(event).contains(handled.to().evolved());
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
                .collect(Collectors.toCollection(ArrayList::new));
    }

    /** It has said nothing since it lost a command. */
    private static boolean hasJustLost(Imitation imitation) {
        List<String> log = imitation.log();
        return !log.isEmpty() && log.get(log.size() - 1).startsWith("loses");
    }

    /** Nothing is going on, and the record is said to be uncertain. */
    private static boolean isInDoubt(SystemEventConverter converter) {
        ConverterStatus status = converter.status();
        return !status.doubt().isEmpty()
                && status.events().waiting() + status.events().inProgress() == 0;
    }

    private static boolean agrees(SystemEventConverter converter, Imitation imitation) {
        ConverterStatus status = converter.status();
        return status.doubt().isEmpty()
                && status.events().waiting() + status.events().inProgress() == 0
                && status.states().original().name().equals(imitation.truth());
    }

    /**
     * Commands that did nothing, but for those that crossed something that the device did by itself. One that is asked has not
     * told that when the command came.
     */
    private static List<String> inVain(List<String> log) {
        return IntStream.range(0, log.size())
                .filter(line -> log.get(line).startsWith("ignores"))
                .filter(line -> line == 0 || !log.get(line - 1).startsWith("does"))
                .mapToObj(line -> log.subList(Math.max(0, line - 2), line + 1).toString())
                .toList();
    }

    private static Path path(ImitatedDevice device) {
        return DEVICES.resolve(device.folder()).resolve(device.folder() + ".yaml");
    }

    private DeviceFile read(ImitatedDevice device, ImitatedDevice.Running running) throws IOException {
        Path from = path(device);
        Files.writeString(folder.resolve("README.md"), Files.readString(from.resolveSibling("README.md")));
        return DeviceFile.read(
                Files.writeString(
                        folder.resolve(String.valueOf(from.getFileName())), running.in(Files.readString(from))),
                DeviceProgram.options());
    }
}
