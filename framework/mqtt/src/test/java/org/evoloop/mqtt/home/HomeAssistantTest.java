package org.evoloop.mqtt.home;

import static org.assertj.core.api.Assertions.assertThat;
import static org.awaitility.Awaitility.await;

import java.io.InputStream;
import java.net.URI;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.evoloop.Logged;
import org.evoloop.console.Console;
import org.evoloop.console.NewModels;
import org.evoloop.mqtt.BrokerAddress;
import org.evoloop.mqtt.BrokerConnection;
import org.evoloop.mqtt.Lamp;
import org.evoloop.mqtt.Mosquitto;
import org.evoloop.mqtt.Watcher;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** A lamp's converter on Debian's Mosquitto, operated as by Home Assistant. */
class HomeAssistantTest {
    private static final Duration LIMIT = Duration.ofSeconds(20);
    private static final String STATE = "evoloop/lamp/state";
    private static final String LIGHT = "evoloop/lamp/light";
    private static final String DECISION = "evoloop/lamp/decision";
    private static final String CONFIG = "homeassistant/device/evoloop_lamp/config";

    @TempDir
    private Path directory;

    private Lamp lamp;
    private Mosquitto broker;
    private HomeAssistant home;
    private Watcher watcher;

    @BeforeEach
    void connect() throws Exception {
        lamp = new Lamp();
        broker = new Mosquitto(directory).start();
        home = new HomeAssistant(lamp.converter, BrokerAddress.parse(broker.url()))
                .entity(HomeEntity.of(HomeKind.LIGHT).mode("warm", "incandescentOn"))
                .choice(new Choice("Model", List.of("day", "night"), () -> "day", wanted -> {
                    throw new IllegalStateException("the model " + wanted + " is not there yet");
                }));
        home.open();
        watcher = new Watcher(broker);
    }

    @AfterEach
    void end() {
        watcher.close();
        home.close();
        lamp.close();
        broker.close();
    }

    @Test
    void everyEntityReadsWhatIsPublished() {
        watcher.awaitNewest("evoloop/lamp/availability", "online");
        watcher.awaitNewest(CONFIG, "\"origin\"");
        watcher.awaitNewest(STATE, "\"battery\":93");
        watcher.awaitNewest("evoloop/lamp/diagnostics", "{");
        watcher.awaitNewest(LIGHT, "{");
        DiscoverySchema.check(
                watcher.newest(CONFIG),
                Map.of(
                        STATE,
                        watcher.newest(STATE),
                        "evoloop/lamp/diagnostics",
                        watcher.newest("evoloop/lamp/diagnostics"),
                        LIGHT,
                        watcher.newest(LIGHT)),
                Set.of("light", "model", "press_switch", "decision", "failure", "reading_battery", "reading_charging"));
    }

    @Test
    void aLongTextIsCutSinceHomeAssistantRefusesIt() {
        lamp.mood = "x".repeat(300);
        watcher.awaitNewest(STATE, "\"mood\":\"" + "x".repeat(250) + "...\"");
    }

    @Test
    void aButtonIsAPressAndWhatBecameOfItIsAnEvent() throws Exception {
        watcher.awaitNewest(STATE, "\"converting\":\"OFF\"");
        watcher.publish("evoloop/lamp/press", "switch", false);
        watcher.awaitHeard(DECISION, "the converter lamp is stopped");
        watcher.awaitHeard("evoloop/lamp/outcome", "\"outcome\":\"refused\"");
        watcher.publish("evoloop/lamp/converting/set", "ON", false);
        watcher.awaitNewest(STATE, "\"converting\":\"ON\"");
        for (int press = 0; press < 3; press++) {
            watcher.publish("evoloop/lamp/press", "switch", false);
        }
        watcher.awaitNewest(STATE, "\"state\":\"incandescentOn\"");
        watcher.awaitNewest(STATE, "\"progress\":\"warming up, warm 40 %\"");
        watcher.awaitHeard(DECISION, "\"event_type\":\"handled\"");
        watcher.awaitHeard(DECISION, "new function of incandescentOn");
        watcher.awaitHeard(
                "evoloop/lamp/outcome",
                "{\"event\":\"switch\",\"outcome\":\"handled\",\"text\":\"handled: incandescentOn\"}");
        assertThat(lamp.bulb.sent()).containsExactly("switch");
    }

    @Test
    void whenATimerIsDueIsPublishedOnce() throws Exception {
        watcher.awaitNewest(STATE, "\"timers\":{},\"next_timer\":null");
        watcher.publish("evoloop/lamp/converting/set", "ON", false);
        watcher.publish("evoloop/lamp/press", "switch", false);
        watcher.publish("evoloop/lamp/press", "switch", false);
        String due = lamp.clock.wallTime().plusSeconds(2).toString();
        watcher.awaitNewest(STATE, "\"timers\":{\"timeout\":\"" + due + "\"},\"next_timer\":\"" + due + "\"");
        lamp.clock.advance(Duration.ofSeconds(1));
        watcher.publish("evoloop/lamp/press", "swich", false);
        watcher.awaitHeard(DECISION, "swich");
        assertThat(watcher.newest(STATE)).contains("\"next_timer\":\"" + due + "\"");
        lamp.clock.advance(Duration.ofSeconds(1));
        watcher.awaitNewest(STATE, "\"next_timer\":null");
    }

    @Test
    void theModelsThatAConsoleOffersAreChosenFrom() throws Exception {
        home.close();
        lamp.close();
        lamp = new Lamp();
        Console console = new Console(lamp.converter, InputStream.nullInputStream(), System.out, System.err);
        console.shownAt(URI.create("http://pi:8080/"));
        console.evolvesBy(NewModels.offering(List.of("lamp.xml#new", "lamp.xml#plain"), lamp::model));
        home = new HomeAssistant(console, BrokerAddress.parse(broker.url() + "?id=choosing")).open();
        watcher.awaitNewest("evoloop/choosing/state", "\"choices\":{\"model\":\"new\"}");
        watcher.awaitNewest("homeassistant/device/evoloop_choosing/config", "\"options\":[\"new\",\"plain\"]");
        watcher.awaitNewest(
                "homeassistant/device/evoloop_choosing/config", "\"configuration_url\":\"http://pi:8080/\"");
        lamp.converter.start();
        watcher.publish("evoloop/choosing/choice/model/set", "plain", false);
        watcher.awaitNewest("evoloop/choosing/state", "\"choices\":{\"model\":\"plain\"}");
        assertThat(lamp.converter.knowledge().models().evolved().name()).isEqualTo("plain");
    }

    @Test
    void whatCannotBeObeyedIsRefusedWithItsReason() throws Exception {
        watcher.awaitNewest("evoloop/lamp/availability", "online");
        watcher.publish("evoloop/lamp/converting/set", "ON", false);
        watcher.publish("evoloop/lamp/press", "swich", false);
        watcher.awaitHeard(DECISION, "switch");
        watcher.publish(LIGHT + "/set", "dance", false);
        watcher.awaitHeard(DECISION, "does not know the command turn_dance");
        watcher.publish("evoloop/lamp/converting/set", "maybe", false);
        watcher.awaitHeard(DECISION, "ON or OFF");
        watcher.publish("evoloop/lamp/choice/model/set", "dusk", false);
        watcher.awaitHeard(DECISION, "there is no Model dusk");
        watcher.publish("evoloop/lamp/choice/model/set", "night", false);
        watcher.awaitHeard(DECISION, "is not there yet");
        assertThat(lamp.bulb.sent()).isEmpty();
    }

    @Test
    void aShadowIsShownWithWhatItWouldDecideAndPromoted() throws Exception {
        watcher.awaitNewest("evoloop/lamp/availability", "online");
        watcher.awaitNewest(CONFIG, "\"origin\"");
        assertThat(watcher.newest(CONFIG)).doesNotContain("shadow");
        watcher.publish("evoloop/lamp/shadow/promote", "PROMOTE", false);
        watcher.awaitHeard(DECISION, "there is no shadow");
        lamp.converter.start();
        lamp.shadow();
        watcher.awaitNewest("evoloop/lamp/shadow", "\"model\":\"plain\"");
        watcher.awaitNewest(CONFIG, "Promote shadow");
        lamp.wallSwitch.press("switch");
        lamp.wallSwitch.press("switch");
        watcher.awaitNewest("evoloop/lamp/shadow", "\"different\":1");
        assertThat(watcher.newest("evoloop/lamp/shadow"))
                .contains("\"now\":\"(on, on) -> (off, off), sends switch", "\"newState\":\"off\"");
        DiscoverySchema.check(
                watcher.newest(CONFIG),
                Map.of(
                        STATE,
                        watcher.newest(STATE),
                        "evoloop/lamp/diagnostics",
                        watcher.newest("evoloop/lamp/diagnostics"),
                        "evoloop/lamp/shadow",
                        watcher.newest("evoloop/lamp/shadow"),
                        LIGHT,
                        watcher.newest(LIGHT)),
                Set.of("light", "promote", "shadow_different"));
        lamp.wallSwitch.press("switch");
        watcher.awaitNewest(STATE, "\"state\":\"incandescentOn\"");
        watcher.publish("evoloop/lamp/shadow/promote", "PROMOTE", false);
        watcher.publish("evoloop/lamp/shadow/promote", "AGAIN", false);
        watcher.awaitHeard(DECISION, "the shadow is already being promoted");
        await().atMost(LIMIT).until(() -> {
            lamp.clock.advance(Duration.ofSeconds(10));
            return watcher.heard().stream().anyMatch(line -> line.contains("has no state incandescentOn"));
        });
        lamp.wallSwitch.press("switch");
        watcher.awaitNewest(STATE, "\"state\":\"off\"");
        watcher.publish("evoloop/lamp/shadow/promote", "PROMOTE", false);
        watcher.awaitNewest("evoloop/lamp/shadow", "{\"different\":null}");
        await().atMost(LIMIT).until(() -> !watcher.newest(CONFIG).contains("incandescentOn"));
        assertThat(watcher.newest(CONFIG)).contains("Promote shadow");
    }

    @Test
    void aViolationOfAPropertyOfTimeIsAnEventThatHasFailed() throws Exception {
        watcher.awaitNewest("evoloop/lamp/availability", "online");
        lamp.converter.start();
        lamp.wallSwitch.press("switch");
        watcher.awaitNewest(STATE, "\"state\":\"on\"");
        lamp.clock.advance(Duration.ofMillis(1));
        watcher.awaitHeard(DECISION, "\"event\":\"violation of Nobody plays with the light\"");
        assertThat(watcher.heard())
                .anyMatch(line -> line.startsWith(DECISION)
                        && line.contains("\"event_type\":\"failed\"")
                        && line.contains("violation of Nobody plays with the light")
                        && line.contains("\"source\":\"property\""));
        watcher.awaitNewest(STATE, "\"last_failure\":\"violation of Nobody plays with the light");
    }

    @Test
    void anEntityObeysItsCommandsAndNoneThatIsOld() throws Exception {
        lamp.converter.start();
        watcher.awaitNewest(LIGHT, "{\"state\":\"off\",\"mode\":null}");
        watcher.publish(LIGHT + "/set", "on", true);
        watcher.awaitNewest(LIGHT, "{\"state\":\"on\",\"mode\":null}");
        try (Logged logged = new Logged("org.evoloop.mqtt");
                BrokerConnection usurper = new BrokerConnection(BrokerAddress.parse(broker.url()), "evoloop-lamp")) {
            usurper.open();
            await().atMost(LIMIT)
                    .untilAsserted(() -> assertThat(logged.lines()).anyMatch(line -> line.contains("retained")));
        }
        // Once more until it is heard: the usurper may have been the last to end the other's connection.
        await().atMost(LIMIT).untilAsserted(() -> {
            watcher.publish(LIGHT + "/mode/set", "warm", false);
            assertThat(watcher.newest(LIGHT)).isEqualTo("{\"state\":\"on\",\"mode\":\"warm\"}");
        });
        watcher.publish(LIGHT + "/set", "on", false);
        watcher.publish(LIGHT + "/set", "off", false);
        watcher.awaitNewest(LIGHT, "{\"state\":\"off\",\"mode\":null}");
        assertThat(presses()).as("what is there already takes no press").isEqualTo(4);
    }

    /** Home Assistant switches a light on before it chooses an effect, without waiting in between. */
    @Test
    void commandsThatComeAtOnceAreObeyedInTheirOrder() throws Exception {
        lamp.converter.start();
        watcher.awaitNewest(LIGHT, "{\"state\":\"off\",\"mode\":null}");
        watcher.publish(LIGHT + "/set", "on", false);
        watcher.publish(LIGHT + "/mode/set", "warm", false);
        watcher.awaitNewest(LIGHT, "\"mode\":\"warm\"");
        assertThat(presses()).isEqualTo(3);
    }

    @Test
    void whatAnEntityCannotDoIsRefusedInWordsAndIsAFailure() throws Exception {
        watcher.awaitNewest("evoloop/lamp/availability", "online");
        watcher.publish(LIGHT + "/mode/set", "blue", false);
        watcher.awaitHeard(DECISION, "does not know the command effect blue");
        watcher.awaitHeard("evoloop/lamp/failure", "\"event_type\":\"refused\"");
        assertThat(presses()).isZero();
    }

    private long presses() {
        return watcher.heard().stream()
                .filter(line -> line.startsWith(DECISION + " ") && line.contains("\"source\":\"controller\""))
                .count();
    }

    @Test
    void aDeviceOutOfReachIsAProblemAndItsReadingsAreUnknown() {
        watcher.awaitNewest(STATE, "\"problem\":\"none\"");
        lamp.up = false;
        watcher.awaitNewest(STATE, "\"problem\":\"out of its socket\"");
        assertThat(watcher.newest(STATE)).contains("\"reachable\":\"OFF\"", "\"readings\":{}");
        assertThat(watcher.newest(CONFIG)).contains("reading_battery");
    }

    @Test
    void everythingIsPublishedAgainWhenHomeAssistantHasStarted() throws Exception {
        watcher.awaitNewest(STATE, "\"system\":\"off\"");
        long before = count(CONFIG);
        watcher.publish("homeassistant/status", "offline", false);
        watcher.publish("homeassistant/status", "online", false);
        await().atMost(LIMIT).until(() -> count(CONFIG) > before);
    }

    private long count(String topic) {
        return watcher.heard().stream()
                .filter(line -> line.startsWith(topic + " "))
                .count();
    }

    @Test
    void aConverterThatEndsIsUnavailable() {
        watcher.awaitNewest("evoloop/lamp/availability", "online");
        home.close();
        watcher.awaitNewest("evoloop/lamp/availability", "offline");
    }

    @Test
    void aConverterThatHasEndedIsUnavailable() {
        watcher.awaitNewest("evoloop/lamp/availability", "online");
        lamp.converter.close();
        watcher.awaitNewest("evoloop/lamp/availability", "offline");
    }

    @Test
    void nothingIsForgottenByARestartOfTheBroker() throws Exception {
        watcher.awaitNewest(STATE, "\"state\":\"off\"");
        watcher.publish("evoloop/lamp/converting/set", "ON", false);
        watcher.awaitNewest(STATE, "\"converting\":\"ON\"");
        watcher.close();
        broker.stop();
        lamp.wallSwitch.press("switch");
        await().atMost(LIMIT).until(() -> lamp.bulb.sent().contains("switch"));
        broker.with("log_type all").start();
        watcher = new Watcher(broker);
        watcher.awaitNewest(STATE, "\"state\":\"on\"");
        watcher.awaitNewest(CONFIG, "\"origin\"");
        watcher.awaitNewest("evoloop/lamp/availability", "online");
        // It is not retained, and may be published before the watcher is there again.
        await().atMost(LIMIT).until(() -> broker.logged("'" + DECISION + "'") > 0);
    }
}
