package org.evoloop.roomba;

import java.nio.file.Path;
import java.time.Duration;
import java.time.LocalTime;
import java.time.ZoneId;
import java.util.concurrent.TimeUnit;
import org.evoloop.RoombaPair;
import org.evoloop.function.QuietHours;
import org.evoloop.mqtt.Mosquitto;
import org.evoloop.mqtt.Watcher;
import org.evoloop.roomba.move.MoveOptions;
import org.evoloop.roomba.move.StartPointSensor;
import org.evoloop.roomba.simulator.robot.RobotOptions;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;

/** When the robot cleans, as its owner changes that while it runs. */
@Timeout(180)
class DayPlanTest {
    private static final String STATE = "evoloop/roomba/state";
    private static final String SET = "evoloop/roomba/setting/";

    @TempDir
    private Path folder;

    @Test
    void quietHoursThatEndEarlierLetItStartEarlier() {
        try (SteppedRoomba roomba = new SteppedRoomba(
                RobotOptions.builder().batteryPercent(100).build(),
                RoombaPair.of("home"),
                MoveOptions.defaults(),
                (robot, clock) -> StartPointSensor.byWheels(Scenario.START_X_MM, Scenario.START_Y_MM))) {
            LocalTime now =
                    roomba.clock.wallTime().atZone(ZoneId.systemDefault()).toLocalTime();
            QuietHours quiet = roomba.roomba.day().quiet();
            quiet.begin(now.minusHours(1));
            quiet.end(now.plusHours(2));
            roomba.press(RobotEvents.SCHEDULE);
            roomba.until(() -> roomba.states().equals(SteppedRoomba.at("Off", "QuietHours")), Duration.ofSeconds(1));
            quiet.end(now);
            roomba.until(() -> roomba.states().equals(SteppedRoomba.at("Clean", "Clean")), Duration.ofSeconds(65));
        }
    }

    @Test
    @EnabledOnOs(OS.LINUX)
    void theScheduleIsChangedSkippedAndSwitchedOff() throws Exception {
        String models = Path.of(System.getProperty("evoloop.root"), "models/roomba.xml") + "#";
        try (Mosquitto broker = new Mosquitto(folder).start();
                Watcher watcher = new Watcher(broker)) {
            Process roomba = Program.startWithLog(
                    folder.resolve("roomba.log"),
                    "--simulate",
                    "--start",
                    "--mqtt=" + broker.url(),
                    "--original=" + models + "original",
                    "--new=" + models + "home",
                    "--clean-at=MON,FRI 09:00",
                    "--quiet-hours=22:00-07:00");
            try {
                watcher.awaitNewest(
                        STATE,
                        "\"settings\":{\"quiet_from\":\"22:00\",\"quiet_until\":\"07:00\",\"schedule\":\"ON\","
                                + "\"clean_at\":\"MON,FRI 09:00\",\"skip_the_next\":\"OFF\"");
                watcher.publish(SET + "quiet_until/set", "08:30:00", false);
                watcher.awaitNewest(STATE, "\"quiet_until\":\"08:30\"");
                watcher.publish(SET + "clean_at/set", "sat,sun 10:00; 18:00", false);
                watcher.awaitNewest(STATE, "\"clean_at\":\"SAT,SUN 10:00; 18:00\"");
                watcher.publish(SET + "clean_at/set", "at noon", false);
                watcher.awaitHeard("evoloop/roomba/failure", "Clean at is at noon; give a time of day");
                watcher.publish(SET + "skip_the_next/set", "ON", false);
                watcher.awaitNewest(STATE, "\"skip_the_next\":\"ON\"");
                watcher.publish(SET + "schedule/set", "OFF", false);
                watcher.awaitNewest(STATE, "\"next_start\":null");
                watcher.publish(SET + "skip_the_next/set", "OFF", false);
                watcher.awaitNewest(STATE, "\"skip_the_next\":\"OFF\"");
                watcher.publish(SET + "skip_the_next/set", "ON", false);
                watcher.awaitHeard("evoloop/roomba/failure", "the schedule is off, so there is nothing to skip");
            } finally {
                roomba.destroy();
                roomba.waitFor(60, TimeUnit.SECONDS);
            }
        }
    }
}
