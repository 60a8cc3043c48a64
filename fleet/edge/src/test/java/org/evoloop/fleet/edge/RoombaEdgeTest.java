package org.evoloop.fleet.edge;

import static org.assertj.core.api.Assertions.assertThat;

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
import org.evoloop.fleet.TestProcess;
import org.evoloop.fleet.broker.LocalBroker;
import org.evoloop.fleet.stream.Fleet;
import org.evoloop.fleet.stream.FleetSettings;
import org.evoloop.fleet.stream.KafkaCluster;
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
import org.junit.jupiter.api.io.CleanupMode;
import org.junit.jupiter.api.io.TempDir;

/** A robot in a fleet: gateway and edge are processes that are killed; Kafka, the MQTT broker and the robot's port are real. */
@Tag("slow")
class RoombaEdgeTest {
    private static final Duration LIMIT = Duration.ofSeconds(90);
    private static final String ROBOT = "robot";

    @TempDir(cleanup = CleanupMode.ON_SUCCESS)
    private Path directory;

    @RegisterExtension
    final SimulatedRoombaExtension roomba = SimulatedRoombaExtension.create().patience(LIMIT);

    private final List<Process> processes = new ArrayList<>();

    @Test
    void aPressAtTheRobotIsDecidedByTheFleetOnceWhicheverProcessIsKilled() throws Exception {
        try (Mosquitto mosquitto = new Mosquitto(directory).start();
                Cluster cluster = Cluster.fresh(2);
                Fleet fleet = new Fleet(KafkaCluster.at(Brokers.shared()), settings(cluster))) {
            serveRobot(fleet, cluster);
            Process gateway = gateway(Brokers.shared(), cluster, mosquitto);
            Process edge = edge(mosquitto, "--no-guard", "--spot-wait", "60");

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
            gateway(Brokers.shared(), cluster, mosquitto);
            awaitState(cluster, "On", "SpotWait");

            // The edge is killed; the new state's function restarts, and ends the state.
            kill(edge);
            edge(mosquitto, "--no-guard", "--spot-wait", "1");
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

    @Test
    void whatTheRobotDoesWhileKafkaIsAwayOrItsCableIsPulledIsKnownAfterwards() throws Exception {
        int port = LocalBroker.freePort();
        int controller = LocalBroker.freePort();
        Path kafka = directory.resolve("kafka");
        LocalBroker broker = LocalBroker.start(kafka, port, controller);
        try (Mosquitto mosquitto = new Mosquitto(directory).start();
                Cluster cluster = new Cluster(KafkaCluster.at(broker.bootstrap()), "robots", 2);
                Fleet fleet = new Fleet(KafkaCluster.at(broker.bootstrap()), settings(cluster))) {
            serveRobot(fleet, cluster);
            gateway(broker.bootstrap(), cluster, mosquitto);
            edge(mosquitto, "--no-guard", "--spot-wait", "1");
            awaitLog("edge-2", "the gateway's broker can be reached");
            roomba.press(Button.CLEAN);
            pressUntilCleaning(cluster);

            // Kafka stops, and somebody stops the robot; the fleet hears of it when Kafka is back, and goes to
            // SpotWait.
            broker.close();
            roomba.press(Button.CLEAN);
            roomba.until(robot -> robot.activity() == RobotActivity.ON);
            broker = LocalBroker.start(kafka, port, controller);
            cluster.readUntil(records -> records.of(Topic.STATES, ROBOT).stream()
                    .anyMatch(state -> state.contains("\"device\":\"On\",\"system\":\"SpotWait\"")));
            awaitState(cluster, "On", "On");
            pressUntilCleaning(cluster);

            // Somebody stops the robot while its cable is pulled: it is found standing when the cable is back.
            roomba.unplug();
            roomba.press(Button.CLEAN);
            roomba.until(robot -> robot.activity() == RobotActivity.ON);
            roomba.replug();
            awaitState(cluster, "On", "On");
            pressUntilCleaning(cluster);
            assertThat(sent(cluster)).containsExactly("Clean", "Clean", "Clean");
            assertThat(cluster.records().of(Topic.DEAD_LETTERS)).isEmpty();
        } finally {
            broker.close();
        }
    }

    @Test
    void theGuardStopsTheRobotWhoseEdgeIsKilled() throws Exception {
        try (Mosquitto mosquitto = new Mosquitto(directory).start();
                Cluster cluster = Cluster.fresh(2);
                Fleet fleet = new Fleet(KafkaCluster.at(Brokers.shared()), settings(cluster))) {
            serveRobot(fleet, cluster);
            gateway(Brokers.shared(), cluster, mosquitto);
            Process edge = edge(mosquitto, "--start-point", "100000,0");
            awaitLog("edge-2", "the gateway's broker can be reached");
            roomba.press(Button.CLEAN);
            awaitState(cluster, "On", "On");
            roomba.until(robot -> robot.oiMode() == OiMode.SAFE);
            roomba.press(Button.SPOT);
            awaitState(cluster, "On", "Move");
            roomba.until(robot -> robot.leftMmPerS() > 0 && robot.rightMmPerS() > 0);
            kill(edge);
            roomba.until(
                    robot -> robot.leftMmPerS() == 0 && robot.rightMmPerS() == 0 && robot.oiMode() == OiMode.PASSIVE);
            edge(mosquitto, "--start-point", "100000,0");
            awaitLog("edge-3", "the gateway's broker can be reached");
        }
    }

    private static void serveRobot(Fleet fleet, Cluster cluster) throws InterruptedException {
        cluster.write(Topic.MODELS, "robot-1", Models.ROBOT.bytes());
        cluster.flush();
        fleet.start();
        assertThat(fleet.awaitRunning(LIMIT)).isTrue();
        cluster.write(Topic.DEVICES, ROBOT, Wire.device("robot-1"));
        awaitState(cluster, "Off", "Off");
    }

    /** The robot, which is on, is pressed once it is under control. */
    private void pressUntilCleaning(Cluster cluster) throws InterruptedException {
        awaitState(cluster, "On", "On");
        roomba.until(robot -> robot.oiMode() == OiMode.SAFE);
        roomba.press(Button.CLEAN);
        awaitState(cluster, "Clean", "Clean");
        roomba.until(robot -> robot.activity() == RobotActivity.CLEAN);
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
                .map(record ->
                        Reading.of(record.getBytes(StandardCharsets.UTF_8)).record())
                .filter(record -> record.text("kind").equals("send"))
                .map(record -> record.text("event"))
                .toList();
    }

    /** The handled events that were pressed or raised, without the states in which the robot was found. */
    private static List<String> decided(Cluster cluster) {
        return cluster.records().of(Topic.DECISIONS, ROBOT).stream()
                .map(record ->
                        Reading.of(record.getBytes(StandardCharsets.UTF_8)).record())
                .filter(record -> record.text("outcome").equals("handled"))
                .map(record -> record.text("occurrence"))
                .filter(occurrence -> !occurrence.startsWith("found"))
                .toList();
    }

    private Process gateway(String bootstrap, Cluster cluster, Mosquitto mosquitto) {
        return start(
                "gateway",
                org.evoloop.fleet.Main.class,
                List.of(
                        "gateway",
                        "--bootstrap",
                        bootstrap,
                        "--name",
                        cluster.fleet(),
                        "--mqtt",
                        mosquitto.url(),
                        "--device",
                        ROBOT,
                        "--journal",
                        directory.resolve("gateway").toString()));
    }

    private Process edge(Mosquitto mosquitto, String... options) {
        String models = Path.of(System.getProperty("evoloop.root", ".."), "models/cleaning-robot.xml")
                .toString();
        List<String> arguments = new ArrayList<>(List.of(
                "edge",
                "--port",
                roomba.port().toString(),
                "--device",
                ROBOT,
                "--mqtt",
                mosquitto.url(),
                "--journal",
                directory.resolve("edge").toString(),
                "--models",
                models));
        arguments.addAll(List.of(options));
        if (!arguments.contains("--start-point")) {
            arguments.addAll(List.of("--start-point", "300,0"));
        }
        return start("edge", org.evoloop.roomba.Main.class, arguments);
    }

    private Process start(String name, Class<?> program, List<String> arguments) {
        Process process =
                TestProcess.start(log(name + "-" + (processes.size() + 1)), program, arguments.toArray(String[]::new));
        processes.add(process);
        return process;
    }

    private Path log(String name) {
        return directory.resolve(name + ".log");
    }

    private void awaitLog(String name, String line) {
        Awaitility.await().atMost(LIMIT).until(() -> Files.readString(log(name)).contains(line));
    }

    /** With SIGKILL. */
    private static void kill(Process process) throws InterruptedException {
        assertThat(process.isAlive()).isTrue();
        TestProcess.kill(process);
    }

    @AfterEach
    void endAll() throws InterruptedException {
        for (Process process : processes) {
            TestProcess.kill(process);
        }
    }
}
