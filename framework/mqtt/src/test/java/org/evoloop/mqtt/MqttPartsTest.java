package org.evoloop.mqtt;

import static org.assertj.core.api.Assertions.assertThat;
import static org.awaitility.Awaitility.await;

import java.nio.file.Path;
import java.time.Duration;
import java.util.Map;
import org.evoloop.LightBulb;
import org.evoloop.converter.SystemEventConverter;
import org.evoloop.evolution.Occurrence;
import org.evoloop.evolution.Source;
import org.evoloop.evolution.Values;
import org.evoloop.loop.LoopConfig;
import org.evoloop.statemachine.Event;
import org.evoloop.time.ManualClock;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** A switch and a lamp that use MQTT, with a converter between them. */
class MqttPartsTest {
    @TempDir
    private Path directory;

    @Test
    void aSwitchAndALampOnTheBrokerAreMonitoredAndOperated() throws Exception {
        try (ManualClock clock = new ManualClock();
                Mosquitto broker = new Mosquitto(directory).start();
                BrokerConnection connection = new BrokerConnection(BrokerAddress.parse(broker.url()), "converter");
                SystemEventConverter converter = new SystemEventConverter(LoopConfig.defaults("lamp", clock));
                Watcher watcher = new Watcher(broker)) {
            converter.addMonitor(new MqttMonitor("WallSwitch", connection)
                    .controller("switch/action", Map.of("single", "switch", "triple", "swich"))
                    .outcomes("switch/outcome")
                    .device("lamp/own", Map.of("toggled", "switch")));
            converter.addExecute(new MqttExecute(
                    "Lamp",
                    new MqttDevice(connection, clock),
                    Map.of("switch", Message.command("lamp/set", "TOGGLE"))));
            converter.addKnowledge(new LightBulb());
            converter.addLink(connection);
            converter.build();
            converter.start();

            converter.offer(press(clock));
            await().atMost(Duration.ofSeconds(20))
                    .untilAsserted(() -> assertThat(converter.history())
                            .anyMatch(entry -> entry.detail().contains("was not sent")));

            watcher.publish("switch/action", "single", true);
            connection.open();
            await().atMost(Duration.ofSeconds(20)).until(connection::isUp);
            watcher.publish("switch/action", "double", false);
            watcher.publish("switch/action", "single", false);
            watcher.awaitNewest("lamp/set", "TOGGLE");
            watcher.awaitHeard("switch/outcome", "\"outcome\":\"handled\"");
            watcher.publish("switch/action", "triple", false);
            watcher.awaitHeard("switch/outcome", "did you mean switch?");
            await().atMost(Duration.ofSeconds(20)).until(() -> state(converter).equals("on"));
            watcher.publish("lamp/own", "toggled", false);
            await().atMost(Duration.ofSeconds(20))
                    .until(() -> converter.status().states().original().name().equals("off"));
            assertThat(converter.status().link().up()).isTrue();
        }
    }

    private static Occurrence press(ManualClock clock) {
        return new Occurrence.Heard(
                new Event("switch"), Values.NONE, Source.CONTROLLER, Occurrence.ANY_VISIT, clock.nanoTime());
    }

    private static String state(SystemEventConverter converter) {
        return converter.status().states().evolved().name();
    }
}
