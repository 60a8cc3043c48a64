package org.evoloop.mqtt.home;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.time.Instant;
import java.time.LocalTime;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.evoloop.mqtt.BrokerAddress;
import org.evoloop.mqtt.Lamp;
import org.evoloop.mqtt.Mosquitto;
import org.evoloop.mqtt.Watcher;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** What is set in Home Assistant, and what the broker keeps of it; on Debian's Mosquitto. */
class HomeSettingsTest {
    private static final String STATE = "evoloop/lamp/state";
    private static final String CONFIG = "homeassistant/device/evoloop_lamp/config";
    private static final String SETTINGS = "evoloop/lamp/settings";

    @TempDir
    private Path directory;

    private Mosquitto broker;
    private Watcher watcher;
    private Lamp lamp;
    private HomeAssistant home;
    private volatile LocalTime quiet;
    private volatile boolean on;
    private volatile String times;

    @BeforeEach
    void connect() throws Exception {
        broker = new Mosquitto(directory).start();
        watcher = new Watcher(broker);
        open("22:00");
        watcher.awaitNewest(STATE, "\"quiet_from\":\"22:00\"");
    }

    /** Starts a converter with this beginning of its quiet hours. */
    private void open(String from) {
        quiet = LocalTime.parse(from);
        on = true;
        times = "09:00";
        lamp = new Lamp();
        home = new HomeAssistant(lamp.converter, BrokerAddress.parse(broker.url()))
                .setting(HomeSetting.time("Quiet from", () -> quiet, time -> quiet = time)
                        .icon("mdi:weather-night"))
                .setting(HomeSetting.onOff("Schedule", () -> on, wanted -> on = wanted))
                .setting(HomeSetting.text("Clean at", () -> times, this::clean))
                .setting(HomeSetting.moment("Next start", () -> Optional.of(Instant.parse("2026-11-29T09:00:00Z"))))
                .pictures(models -> "<svg>" + models.evolved().name() + "</svg>")
                .open();
    }

    private void clean(String wanted) {
        if (wanted.isEmpty()) {
            throw new IllegalArgumentException("give a time");
        }
        times = wanted;
    }

    private void close() {
        home.close();
        lamp.close();
    }

    private void restart(String from) {
        close();
        watcher.awaitNewest("evoloop/lamp/availability", "offline");
        open(from);
        watcher.awaitNewest("evoloop/lamp/availability", "online");
    }

    @AfterEach
    void end() {
        watcher.close();
        close();
        broker.close();
    }

    @Test
    void eachIsAnEntityOfItsKind() {
        watcher.awaitNewest(CONFIG, "\"origin\"");
        watcher.awaitNewest("evoloop/lamp/diagnostics", "{");
        DiscoverySchema.check(
                watcher.newest(CONFIG),
                Map.of(
                        STATE,
                        watcher.newest(STATE),
                        "evoloop/lamp/diagnostics",
                        watcher.newest("evoloop/lamp/diagnostics")),
                Set.of("quiet_from", "schedule", "clean_at", "next_start", "picture"));
        assertThat(watcher.newest(CONFIG)).contains("\"default_entity_id\":\"time.lamp_quiet_from\"");
        assertThat(watcher.newest(STATE))
                .contains("\"settings\":{\"quiet_from\":\"22:00\",\"schedule\":\"ON\",\"clean_at\":\"09:00\","
                        + "\"next_start\":\"2026-11-29T09:00:00Z\"}");
        watcher.awaitNewest("evoloop/lamp/picture/picture", "</svg>");
    }

    @Test
    void whatIsSetCountsAtOnceAndAfterARestart() throws Exception {
        watcher.publish("evoloop/lamp/setting/quiet_from/set", "21:30:00", false);
        watcher.awaitNewest(STATE, "\"quiet_from\":\"21:30\"");
        watcher.publish("evoloop/lamp/setting/schedule/set", "OFF", false);
        watcher.awaitNewest(STATE, "\"schedule\":\"OFF\"");
        watcher.awaitNewest(SETTINGS, "\"schedule\":{\"usual\":\"ON\",\"now\":\"OFF\"}");
        restart("22:00");
        watcher.awaitNewest(STATE, "\"quiet_from\":\"21:30\",\"schedule\":\"OFF\"");
        assertThat(on).isFalse();
        restart("22:00");
        watcher.awaitNewest(STATE, "\"quiet_from\":\"21:30\",\"schedule\":\"OFF\"");
    }

    @Test
    void whoStartsItWithSomethingElseWantsThat() throws Exception {
        watcher.publish("evoloop/lamp/setting/quiet_from/set", "21:30:00", false);
        watcher.awaitNewest(SETTINGS, "21:30");
        watcher.publish("evoloop/lamp/setting/schedule/set", "OFF", false);
        watcher.awaitNewest(SETTINGS, "\"now\":\"OFF\"");
        restart("20:00");
        watcher.awaitNewest(STATE, "\"quiet_from\":\"20:00\",\"schedule\":\"OFF\"");
    }

    @Test
    void aBrokerThatForgetsIsTold() throws Exception {
        watcher.publish("evoloop/lamp/setting/quiet_from/set", "21:30:00", false);
        watcher.awaitNewest(SETTINGS, "21:30");
        restart("22:00");
        watcher.awaitNewest(STATE, "21:30");
        watcher.close();
        broker.stop();
        broker.start();
        watcher = new Watcher(broker);
        watcher.awaitNewest(SETTINGS, "\"quiet_from\":{\"usual\":\"22:00\",\"now\":\"21:30\"}");
    }

    @Test
    void whatCannotBeSetIsRefusedInWords() throws Exception {
        watcher.awaitNewest("evoloop/lamp/availability", "online");
        watcher.publish("evoloop/lamp/setting/quiet_from/set", "late", false);
        watcher.awaitHeard("evoloop/lamp/failure", "Quiet from is a time of day such as 22:00, not late");
        watcher.publish("evoloop/lamp/setting/schedule/set", "maybe", false);
        watcher.awaitHeard("evoloop/lamp/failure", "Schedule is ON or OFF, not maybe");
        watcher.publish("evoloop/lamp/setting/clean_at/set", "", false);
        watcher.awaitHeard("evoloop/lamp/failure", "give a time");
        assertThat(watcher.newest(STATE))
                .contains("\"quiet_from\":\"22:00\",\"schedule\":\"ON\",\"clean_at\":\"09:00\"");
    }

    @Test
    void whatSomebodyElseRetainedIsIgnored() throws Exception {
        watcher.publish(SETTINGS, "nonsense", true);
        restart("22:00");
        watcher.publish("evoloop/lamp/setting/quiet_from/set", "21:30:00", false);
        watcher.awaitNewest(STATE, "21:30");
    }
}
