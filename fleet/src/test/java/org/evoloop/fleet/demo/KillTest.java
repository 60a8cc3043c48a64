package org.evoloop.fleet.demo;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.File;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.concurrent.TimeUnit;
import org.apache.kafka.clients.admin.Admin;
import org.evoloop.fleet.BrokerProcess;
import org.evoloop.fleet.Main;
import org.evoloop.fleet.Models;
import org.evoloop.fleet.broker.LocalBroker;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Processes that are killed (SIGKILL) while lamps are pressed. */
@Tag("slow")
class KillTest {
    private static final int INSTANCES = 3;
    private static final String FLEET = "killed";

    @TempDir
    private Path directory;

    private final Random random = new Random(3);
    private volatile int restarts;
    private final Map<Integer, Process> instances = new HashMap<>();

    @Test
    void nothingIsLostAndNothingIsDoneTwiceWhenInstancesAndTheBrokerAreKilled() throws Exception {
        int kills = Integer.getInteger("kills", 100);
        int port = LocalBroker.freePort();
        int controller = LocalBroker.freePort();
        String bootstrap = "localhost:" + port;
        Process broker = broker(port, controller, bootstrap);
        try (PressedLamps lamps = new PressedLamps(bootstrap, FLEET, 60, Models.LAMP)) {
            for (int each = 0; each < INSTANCES; each++) {
                start(each, bootstrap);
            }
            lamps.register();
            for (int kill = 1; kill <= kills; kill++) {
                int victim = random.nextInt(INSTANCES);
                lamps.press(100);
                kill(victim);
                lamps.press(100);
                start(victim, bootstrap);
                lamps.press(100);
                if (kill % 10 == 0) {
                    end(broker);
                    broker = broker(port, controller, bootstrap);
                }
                lamps.awaitDecided(200L * kill);
                System.out.println("kill " + kill + ", pressed " + lamps.pressed() + ", started again " + restarts);
            }
            lamps.settle();
            assertThat(lamps.pressed()).isEqualTo(300L * kills);
        } finally {
            for (int each = 0; each < INSTANCES; each++) {
                kill(each);
            }
            end(broker);
        }
    }

    private synchronized void start(int number, String bootstrap) {
        Process instance = java(
                Main.class,
                "fleet",
                "--bootstrap",
                bootstrap,
                "--name",
                FLEET,
                "--session-ms",
                "3000",
                "--state-dir",
                directory.resolve("instance-" + number).toString());
        instances.put(number, instance);
        instance.onExit().thenAccept(ended -> startAgain(number, ended, bootstrap));
    }

    /** Restarts an instance that exited because it found no broker, as a service manager does. */
    private synchronized void startAgain(int number, Process ended, String bootstrap) {
        if (instances.get(number) == ended) {
            restarts++;
            start(number, bootstrap);
        }
    }

    private void kill(int number) throws InterruptedException {
        Process victim;
        synchronized (this) {
            victim = instances.remove(number);
        }
        if (victim != null) {
            end(victim);
        }
    }

    private Process broker(int port, int controller, String bootstrap) throws Exception {
        Process broker = java(
                BrokerProcess.class,
                directory.resolve("broker").toString(),
                String.valueOf(port),
                String.valueOf(controller));
        // The call returns as soon as the broker runs.
        try (Admin admin = Admin.create(Map.of(
                "bootstrap.servers", bootstrap, "default.api.timeout.ms", "120000", "request.timeout.ms", "5000"))) {
            admin.describeCluster().nodes().get(120, TimeUnit.SECONDS);
        }
        return broker;
    }

    private Process java(Class<?> program, String... arguments) {
        List<String> command = new ArrayList<>(List.of(
                Path.of(System.getProperty("java.home"), "bin", "java").toString(),
                "-XX:TieredStopAtLevel=1",
                "-XX:+UseSerialGC",
                "-cp",
                System.getProperty("java.class.path"),
                program.getName()));
        command.addAll(List.of(arguments));
        File log = directory.resolve(program.getSimpleName() + ".log").toFile();
        try {
            return new ProcessBuilder(command)
                    .redirectErrorStream(true)
                    .redirectOutput(ProcessBuilder.Redirect.appendTo(log))
                    .start();
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    private static void end(Process process) throws InterruptedException {
        process.destroyForcibly().waitFor();
    }
}
