package org.evoloop.fleet.demo;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.HashMap;
import java.util.Map;
import java.util.Random;
import org.evoloop.fleet.BrokerProcess;
import org.evoloop.fleet.Main;
import org.evoloop.fleet.MemoryFleetProcess;
import org.evoloop.fleet.Models;
import org.evoloop.fleet.TestProcess;
import org.evoloop.fleet.broker.LocalBroker;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.CleanupMode;
import org.junit.jupiter.api.io.TempDir;

/**
 * Processes that are killed (SIGKILL) while lamps are pressed.
 *
 * <p>System properties: {@code kills} of instances, {@code killsPerBroker} for each of the broker, {@code inMemory}
 * instances that keep their devices in memory, the others on disk.
 */
@Tag("slow")
class KillTest {
    private static final int INSTANCES = 3;
    private static final String FLEET = "killed";
    private static final String SESSION_MILLIS = "3000";
    private static final int IN_MEMORY = Integer.getInteger("inMemory", 1);

    @TempDir(cleanup = CleanupMode.ON_SUCCESS)
    private Path directory;

    private final Random random = new Random(3);
    private volatile int restarts;
    private final Map<Integer, Process> instances = new HashMap<>();

    @Test
    void nothingIsLostAndNothingIsDoneTwiceWhenInstancesAndTheBrokerAreKilled() throws Exception {
        int kills = Integer.getInteger("kills", 100);
        int killsPerBroker = Integer.getInteger("killsPerBroker", 10);
        int port = LocalBroker.freePort();
        int controller = LocalBroker.freePort();
        String bootstrap = "localhost:" + port;
        Process broker = BrokerProcess.start(directory, port, controller);
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
                if (kill % killsPerBroker == 0) {
                    TestProcess.kill(broker);
                    broker = BrokerProcess.start(directory, port, controller);
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
            TestProcess.kill(broker);
        }
    }

    private synchronized void start(int number, String bootstrap) {
        Path log = directory.resolve("instance-" + number + ".log");
        String state = directory.resolve("instance-" + number).toString();
        Process instance = number < IN_MEMORY
                ? TestProcess.start(log, MemoryFleetProcess.class, bootstrap, FLEET, SESSION_MILLIS, state)
                : TestProcess.start(
                        log,
                        Main.class,
                        "fleet",
                        "--bootstrap",
                        bootstrap,
                        "--name",
                        FLEET,
                        "--session-ms",
                        SESSION_MILLIS,
                        "--state-dir",
                        state);
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
            TestProcess.kill(victim);
        }
    }
}
