package org.evoloop.models;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.net.ServerSocket;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Collectors;
import org.evoloop.device.DeviceFile;
import org.evoloop.device.DeviceProgram;
import org.evoloop.device.ImitatedDevice;
import org.evoloop.imitation.Faults;
import org.evoloop.imitation.Imitation;
import org.evoloop.mqtt.Mosquitto;
import org.evoloop.statemachine.State;
import org.evoloop.statemachine.StateMachine;
import org.evoloop.statemachine.Transition;
import org.evoloop.xmi.ModelReference;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import picocli.CommandLine;

/** The devices of {@code devices} are learned from their files: what is found is what their READMEs draw. */
class LearnImitatedDevicesTest {
    private static final Path DEVICES = Path.of(System.getProperty("evoloop.root", "../.."), "devices");

    private static final Duration SETTLE = Duration.ofMillis(50);
    private static final Duration SHORT_SETTLE = Duration.ofMillis(20);
    /** How long what moves is on its way, in settle times: much longer than it takes to press something. */
    private static final int WAY = 12;

    private static final String BUDGET = "10 min";

    @TempDir
    private Path folder;

    private final StringWriter out = new StringWriter();

    @ParameterizedTest
    @EnumSource(names = {"ZIGBEE_BULB", "WASHING_MACHINE"})
    void smallOnesAreWhatTheirReadmesDraw(ImitatedDevice device) throws Exception {
        isWhatItsReadmeDraws(device, Set.of());
    }

    @ParameterizedTest
    @EnumSource(names = {"AIR_CONDITIONER", "OCTOPRINT"})
    @Tag("slow")
    void largerOnesAreWhatTheirReadmesDraw(ImitatedDevice device) throws Exception {
        isWhatItsReadmeDraws(device, Set.of());
    }

    @ParameterizedTest
    @EnumSource(names = {"VALETUDO"})
    @Tag("slow")
    void aRobotThatTakesItsTimeToComeHomeIsWhatItsReadmeDraws(ImitatedDevice device) throws Exception {
        isWhatItsReadmeDraws(device, Set.of("docks"));
    }

    @Test
    @Tag("slow")
    void aShutterIsWhatItsReadmeDraws() throws Exception {
        isWhatItsReadmeDraws(ImitatedDevice.ROLLER_SHUTTER, Set.of("opened", "closed", "gap reached", "sun reached"));
    }

    @Test
    void theTutorialsFanIsWhatItsReadmeDraws() throws Exception {
        int port;
        try (ServerSocket probe = new ServerSocket(0)) {
            port = probe.getLocalPort();
        }
        Path original = file("fan");
        Process fan = new ProcessBuilder(
                        "python3",
                        original.resolveSibling("../../docs/fan/fan.py").toString(),
                        String.valueOf(port))
                .redirectErrorStream(true)
                .redirectOutput(folder.resolve("fan.log").toFile())
                .start();
        try {
            learn(original, Files.readString(original).replace(":4001", ":" + port), SETTLE, Set.of());
        } finally {
            fan.destroy();
            fan.waitFor();
        }
        assertThat(Files.readAllLines(folder.resolve("fan.log"))).last().isEqualTo("the fan is Off");
    }

    private static Path file(String device) {
        return DEVICES.resolve(device).resolve(device + ".yaml");
    }

    /** @param arrivals what the device does by itself some time after it could */
    private void isWhatItsReadmeDraws(ImitatedDevice device, Set<String> arrivals) throws Exception {
        Path original = file(device.folder());
        StateMachine drawn = drawn(original);
        // One that cannot be asked must have told where it is.
        Duration settle = arrivals.isEmpty() || !device.canBeAsked() ? SETTLE : SHORT_SETTLE;
        try (Mosquitto broker =
                        new Mosquitto(folder).with("set_tcp_nodelay true").start();
                Imitation imitation = new Imitation(drawn, Faults.NONE, 1)
                        .arriving(arrivals.stream()
                                .collect(Collectors.toMap(event -> event, event -> settle.multipliedBy(WAY))));
                ImitatedDevice.Running running =
                        device.imitate(Files.createDirectory(folder.resolve("own")), broker, imitation)) {
            learn(original, running.in(Files.readString(original)), settle, arrivals);
            assertThat(imitation.truth()).isEqualTo(drawn.initial().name());
        }
    }

    private static StateMachine drawn(Path original) {
        return DeviceFile.read(original, DeviceProgram.options()).models().original();
    }

    private void learn(Path original, String text, Duration settle, Set<String> arrivals) throws IOException {
        Path own = Files.createDirectories(folder.resolve("own"));
        Files.writeString(own.resolve("README.md"), Files.readString(original.resolveSibling("README.md")));
        Path file = Files.writeString(
                own.resolve("device.yaml"),
                text.replaceFirst("settle: [0-9]+ m?s", "settle: " + settle.toMillis() + " ms"));
        Path learned = folder.resolve("learned.mmd");
        CommandLine command = Main.learning();
        command.setOut(new PrintWriter(out, true));
        assertThat(Main.run(
                        command,
                        file.toString(),
                        "--output=" + learned,
                        "--longest="
                                + settle.multipliedBy(arrivals.isEmpty() ? 2 : 2 * WAY)
                                        .toMillis() + " ms",
                        "--budget=" + BUDGET))
                .as(out.toString())
                .isZero();
        assertThat(edges(ModelReference.parse(learned + "#original").load(), Set.of()))
                .as(out.toString())
                .isEqualTo(edges(drawn(original), arrivals));
        out.toString()
                .lines()
                .filter(line -> line.contains(" states, "))
                .forEach(line -> System.out.println(original.getFileName() + ": " + line));
    }

    /**
     * The transitions that a learner can see from its first state: what is pressed, and of what the device does by itself that
     * which it does in the time in which a state is observed.
     */
    private static Set<String> edges(StateMachine machine, Set<String> arrivals) {
        Set<String> edges = new TreeSet<>();
        List<State> reached = new ArrayList<>(List.of(machine.initial()));
        for (int i = 0; i < reached.size(); i++) {
            for (Transition each : machine.transitionsFrom(reached.get(i))) {
                boolean itself = each.event().timeTrigger().isPresent()
                        || arrivals.contains(each.event().name());
                if (!itself && machine.spontaneous().contains(each.event())) {
                    continue;
                }
                edges.add(each.source() + " "
                        + (itself ? "by itself" : each.event().trigger()) + " " + each.target());
                if (!reached.contains(each.target())) {
                    reached.add(each.target());
                }
            }
        }
        return edges;
    }
}
