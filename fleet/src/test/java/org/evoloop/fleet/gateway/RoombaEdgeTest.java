package org.evoloop.fleet.gateway;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import org.awaitility.Awaitility;
import org.evoloop.fleet.Brokers;
import org.evoloop.fleet.Cluster;
import org.evoloop.fleet.Models;
import org.evoloop.fleet.stream.Fleet;
import org.evoloop.fleet.stream.FleetSettings;
import org.evoloop.fleet.wire.Reading;
import org.evoloop.fleet.wire.Topic;
import org.evoloop.fleet.wire.Wire;
import org.evoloop.mqtt.Mosquitto;
import org.evoloop.roomba.oi.Button;
import org.evoloop.roomba.oi.OiMode;
import org.evoloop.roomba.simulator.robot.RobotActivity;
import org.evoloop.roomba.testkit.SimulatedRoombaExtension;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.extension.RegisterExtension;
import org.junit.jupiter.api.io.TempDir;

/** A robot in a fleet: gateway and edge are processes that are killed; Kafka, the MQTT broker and the robot's port are real. */
@Tag("slow")
class RoombaEdgeTest {
    private static final Duration LIMIT = Duration.ofSeconds(90);
    private static final String ROBOT = "robot";

    @TempDir
    private Path directory;

    @RegisterExtension
    final SimulatedRoombaExtension roomba = SimulatedRoombaExtension.create().patience(LIMIT);

    private final List<Process> processes = new ArrayList<>();

    @Test
    void aPressAtTheRobotIsDecidedByTheFleetOnceWhicheverProcessIsKilled() throws Exception {
        try (Mosquitto mosquitto = new Mosquitto(directory).start();
                Cluster cluster = Cluster.fresh(2);
                Fleet fleet = new Fleet(Brokers.shared(), settings(cluster))) {
            cluster.write(Topic.MODELS, "robot-1", Models.ROBOT.bytes());
            cluster.flush();
            fleet.start();
            assertThat(fleet.awaitRunning(LIMIT)).isTrue();
            cluster.write(Topic.DEVICES, ROBOT, Wire.device("robot-1"));
            awaitState(cluster, "Off", "Off");
            Process gateway = gateway(cluster, mosquitto);
            Process edge = edge(mosquitto, "60");

            // First the robot acts by itself and the fleet follows; then it is under control and the fleet decides.
            awaitLog("edge-2", "the gateway's broker can be reached");
            roomba.press(Button.CLEAN);
            awaitState(cluster, "On", "On");
            roomba.until(robot -> robot.oiMode() == OiMode.SAFE);
            roomba.press(Button.CLEAN);
            awaitState(cluster, "Clean", "Clean");
            roomba.until(robot -> robot.activity() == RobotActivity.CLEAN);
            assertThat(sent(cluster)).containsExactly("Clean");

            // The gateway is killed; presses in the meantime arrive after its restart.
            kill(gateway);
            roomba.press(Button.CLEAN);
            roomba.until(robot -> robot.activity() == RobotActivity.ON);
            gateway(cluster, mosquitto);
            awaitState(cluster, "On", "SpotWait");

            // The edge is killed; the new state's function restarts, and ends the state.
            kill(edge);
            edge(mosquitto, "1");
            awaitState(cluster, "On", "On");

            // Move runs at the robot, which cleans where it arrives.
            roomba.until(robot -> robot.oiMode() == OiMode.SAFE);
            roomba.press(Button.SPOT);
            awaitState(cluster, "On", "Move");
            awaitState(cluster, "Spot", "Spot");
            roomba.until(robot -> robot.activity() == RobotActivity.SPOT);

            assertThat(sent(cluster)).containsExactly("Clean", "Spot");
            // That the robot was switched on may also have been found.
            assertThat(decided(cluster))
                    .endsWith("Clean", "Clean", "timeout", "Spot", "arriveSpot")
                    .hasSizeBetween(5, 6);
            assertThat(cluster.records().of(Topic.DEAD_LETTERS)).isEmpty();
        }
    }

    private FleetSettings settings(Cluster cluster) {
        return FleetSettings.defaults().withFleet(cluster.fleet()).withStateDirectory(directory.resolve("state"));
    }

    private static void awaitState(Cluster cluster, String device, String system) {
        cluster.readUntil(records -> {
            List<String> states = records.of(Topic.STATES, ROBOT);
            return !states.isEmpty()
                    && states.get(states.size() - 1)
                            .contains("\"device\":\"" + device + "\",\"system\":\"" + system + "\"");
        });
    }

    private static List<String> sent(Cluster cluster) {
        return cluster.records().of(Topic.COMMANDS, ROBOT).stream()
                .map(record -> Reading.of(record.getBytes(StandardCharsets.UTF_8)))
                .filter(record -> record.text("kind").equals("send"))
                .map(record -> record.text("event"))
                .toList();
    }

    /** The handled events that were pressed or raised, without the states in which the robot was found. */
    private static List<String> decided(Cluster cluster) {
        return cluster.records().of(Topic.DECISIONS, ROBOT).stream()
                .map(record -> Reading.of(record.getBytes(StandardCharsets.UTF_8)))
                .filter(record -> record.text("outcome").equals("handled"))
                .map(record -> record.text("occurrence"))
                .filter(occurrence -> !occurrence.startsWith("found"))
                .toList();
    }

    private Process gateway(Cluster cluster, Mosquitto mosquitto) {
        return start(
                "gateway",
                "org.evoloop.fleet.Main",
                List.of(
                        "gateway",
                        "--bootstrap",
                        bootstrap(),
                        "--name",
                        cluster.fleet(),
                        "--mqtt",
                        mosquitto.url(),
                        "--device",
                        ROBOT,
                        "--journal",
                        directory.resolve("gateway").toString()));
    }

    private static String bootstrap() {
        try {
            return Brokers.shared();
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    private Process edge(Mosquitto mosquitto, String spotWait) {
        String models = Path.of(System.getProperty("evoloop.root", ".."), "models/cleaning-robot.xml")
                .toString();
        return start(
                "edge",
                "org.evoloop.roomba.Main",
                List.of(
                        "edge",
                        "--port",
                        roomba.port().toString(),
                        "--device",
                        ROBOT,
                        "--mqtt",
                        mosquitto.url(),
                        "--journal",
                        directory.resolve("edge").toString(),
                        "--no-guard",
                        "--models",
                        models,
                        "--spot-wait",
                        spotWait,
                        "--start-point",
                        "300,0"));
    }

    private Process start(String name, String program, List<String> arguments) {
        List<String> command = new ArrayList<>(List.of(
                Path.of(System.getProperty("java.home"), "bin", "java").toString(),
                "-Xmx256m",
                "-XX:+UseSerialGC",
                "-cp",
                System.getProperty("java.class.path"),
                program));
        command.addAll(arguments);
        try {
            Process process = new ProcessBuilder(command)
                    .redirectErrorStream(true)
                    .redirectOutput(log(name + "-" + (processes.size() + 1)).toFile())
                    .start();
            processes.add(process);
            return process;
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    private static Path log(String name) throws IOException {
        Path logs = Path.of("target", "edge-logs");
        Files.createDirectories(logs);
        return logs.resolve(name + ".log");
    }

    private static void awaitLog(String name, String line) {
        Awaitility.await().atMost(LIMIT).until(() -> Files.readString(log(name)).contains(line));
    }

    /** With SIGKILL. */
    private static void kill(Process process) throws InterruptedException {
        assertThat(process.isAlive()).isTrue();
        process.destroyForcibly().waitFor();
    }

    @AfterEach
    void endAll() throws InterruptedException {
        for (Process process : processes) {
            process.destroyForcibly().waitFor();
        }
    }
}
