package org.evoloop.roomba;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.concurrent.TimeUnit;
import org.awaitility.Awaitility;
import org.evoloop.mqtt.Mosquitto;
import org.evoloop.mqtt.Watcher;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;

/** The program with a simulated robot on Debian's Mosquitto, operated as by Home Assistant. */
@EnabledOnOs(OS.LINUX)
@Timeout(180)
class AtHomeTest {
    private static final String STATE = "evoloop/roomba/state";
    private static final String VACUUM = "evoloop/roomba/vacuum";
    private static final String COMMAND = "evoloop/roomba/vacuum/set";
    private static final String DECISION = "evoloop/roomba/decision";

    @TempDir
    private Path folder;

    @Test
    void theVacuumCleansPausesAndCleansASpotAndNothingIsKeptOfItsEnd() throws Exception {
        Path log = folder.resolve("roomba.log");
        try (Mosquitto broker = new Mosquitto(folder).start();
                Watcher watcher = new Watcher(broker)) {
            Process roomba = Program.startWithLog(
                    log, "--simulate", "--speed", "10", "--start", "--spot-wait", "20", "--mqtt", broker.url());
            try {
                watcher.awaitNewest(VACUUM, "idle");
                assertThat(watcher.newest("homeassistant/device/evoloop_roomba/config"))
                        .contains("\"supported_features\":[\"start\",\"stop\",\"pause\",\"clean_spot\",\"locate\",");
                watcher.publish(COMMAND, "start", false);
                watcher.awaitNewest(VACUUM, "cleaning");
                watcher.awaitNewest(STATE, "\"device_state\":\"Clean\"");
                watcher.publish(COMMAND, "pause", false);
                watcher.awaitNewest(STATE, "\"state\":\"SpotWait\"");
                watcher.awaitNewest(VACUUM, "paused");
                watcher.awaitNewest(STATE, "\"state\":\"On\"");
                watcher.awaitNewest(VACUUM, "paused");
                watcher.publish(COMMAND, "locate", false);
                watcher.publish(COMMAND, "return_to_base", false);
                watcher.awaitHeard(DECISION, "does not say what Dock does in On");
                watcher.publish(COMMAND, "clean_spot", false);
                watcher.awaitNewest(STATE, "\"state\":\"Move\"");
                watcher.awaitNewest(VACUUM, "cleaning");
                assertThat(watcher.heard()).noneMatch(line -> line.contains("\"event\":\"locate\""));
            } finally {
                roomba.destroy();
                assertThat(roomba.waitFor(60, TimeUnit.SECONDS)).isTrue();
            }
            watcher.awaitNewest("evoloop/roomba/availability", "offline");
            // On a computer too busy for tenfold speed, the recorded state may briefly be in doubt.
            assertThat(Files.readString(log).lines())
                    .noneMatch(line -> line.contains("WARN") && !line.contains("in doubt"))
                    .noneMatch(line -> line.contains("Exception"));
        }
    }

    @Test
    void onItsDockItStaysUntilItIsStartedAndIsThenNotDockedAgain() throws Exception {
        String models = Path.of(System.getProperty("evoloop.root"), "models/roomba.xml") + "#";
        try (Mosquitto broker = new Mosquitto(folder).start();
                Watcher watcher = new Watcher(broker)) {
            Process roomba = Program.startWithLog(
                    folder.resolve("roomba.log"),
                    "--simulate",
                    "--speed=10",
                    "--start",
                    "--mqtt=" + broker.url(),
                    "--original=" + models + "original",
                    "--new=" + models + "home");
            try {
                watcher.awaitNewest(VACUUM, "idle");
                OtherRobot.type(roomba, "robot dock\n");
                watcher.awaitNewest(VACUUM, "docked");
                for (String command : List.of("stop", "pause", "return_to_base")) {
                    watcher.publish(COMMAND, command, false);
                }
                // The dock's button does nothing on the dock; it is decided after whatever the commands have pressed.
                watcher.publish("evoloop/roomba/press", "Dock", false);
                watcher.awaitHeard(DECISION, "\"event\":\"Dock\"");
                assertThat(watcher.heard())
                        .filteredOn(line -> line.contains("\"source\":\"controller\""))
                        .hasSize(1);
                watcher.publish(COMMAND, "start", false);
                watcher.awaitNewest(VACUUM, "cleaning");
                watcher.publish(COMMAND, "stop", false);
                // It is stopped on its dock, or before it, as far as it has come by then.
                Awaitility.await()
                        .atMost(Duration.ofMinutes(1))
                        .until(() -> !watcher.newest(VACUUM).contains("cleaning"));
                assertThat(watcher.heard())
                        .filteredOn(line -> line.startsWith(VACUUM + " "))
                        .containsSequence(VACUUM + " {\"state\":\"docked\"}", VACUUM + " {\"state\":\"cleaning\"}")
                        .filteredOn(line -> line.contains("cleaning"))
                        .hasSize(1);
            } finally {
                roomba.destroy();
                assertThat(roomba.waitFor(60, TimeUnit.SECONDS)).isTrue();
            }
        }
    }
}
