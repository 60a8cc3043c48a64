package org.evoloop.mqtt;

import static org.assertj.core.api.Assertions.assertThat;

import com.code_intelligence.jazzer.api.BugDetectors;
import com.code_intelligence.jazzer.api.SilentCloseable;
import com.code_intelligence.jazzer.junit.FuzzTest;
import com.hivemq.client.mqtt.MqttGlobalPublishFilter;
import com.hivemq.client.mqtt.mqtt5.Mqtt5AsyncClient;
import com.hivemq.client.mqtt.mqtt5.Mqtt5Client;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import org.evoloop.mqtt.home.Choice;
import org.evoloop.mqtt.home.HomeAssistant;
import org.evoloop.mqtt.home.HomeEntity;
import org.evoloop.mqtt.home.HomeKind;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.provider.MethodSource;

/**
 * Whatever is published on the topics of a converter, its bypass and Home Assistant's commands, each of the three still
 * receives the next message. The broker is Mosquitto.
 */
@Timeout(60)
class MessagesFuzzTest {
    private static final int PATIENCE_SECONDS = 20;
    private static final String BYPASS = "evoloop/lamp/bypass";
    private static final List<String> TOPICS = List.of(
            "evoloop/lamp/press",
            "evoloop/lamp/converting/set",
            "evoloop/lamp/shadow/promote",
            "evoloop/lamp/light/set",
            "evoloop/lamp/light/mode/set",
            "evoloop/lamp/choice/model/set",
            "homeassistant/status",
            "wall/action",
            "wall/hand",
            BYPASS + "/passed",
            BYPASS + "/told",
            BYPASS + "/converter",
            BYPASS + "/own");

    /** Shared by all inputs, so that anything that one message leaves behind affects the next. */
    private static final class Parts {
        private static final Parts PARTS = new Parts();

        private final Mqtt5AsyncClient anybody;
        private final LinkedBlockingQueue<String> refusals = new LinkedBlockingQueue<>();
        private final LinkedBlockingQueue<String> ticks = new LinkedBlockingQueue<>();
        private int number;

        private Parts() {
            try (SilentCloseable ours = BugDetectors.allowNetworkConnections()) {
                Path directory = Files.createTempDirectory("evoloop-fuzz");
                Mosquitto broker = new Mosquitto(directory).start();
                Lamp lamp = new Lamp();
                BrokerAddress address = BrokerAddress.parse(broker.url());
                HomeAssistant home = new HomeAssistant(lamp.converter, address)
                        .entity(HomeEntity.of(HomeKind.LIGHT).mode("warm", "incandescentOn"))
                        .choice(new Choice("Model", List.of("day", "night"), () -> "day", wanted -> {}))
                        .open();
                BrokerConnection wall = new BrokerConnection(address, "wall");
                lamp.converter.addMonitor(new MqttMonitor("Wall", wall)
                        .controller("wall/action", Map.of("single", "switch"))
                        .device("wall/hand", Map.of("toggled", "switch"))
                        .bypassed(BYPASS));
                wall.subscribe("tick", message -> ticks.add(message.payload()));
                wall.open();
                BrokerConnection second = new BrokerConnection(address, "second");
                MqttBypass bypass = new MqttBypass(
                                second, BYPASS, Map.of("switch", Message.command("lamp/set", "toggle")))
                        .controller("wall/action", Map.of("single", "switch"));
                second.subscribe("tick", message -> ticks.add(message.payload()));
                bypass.open();
                anybody = Mqtt5Client.builder()
                        .serverHost("127.0.0.1")
                        .serverPort(broker.port())
                        .buildAsync();
                anybody.publishes(
                        MqttGlobalPublishFilter.ALL,
                        publish -> refusals.add(new String(publish.getPayloadAsBytes(), StandardCharsets.UTF_8)));
                anybody.connect().get(PATIENCE_SECONDS, TimeUnit.SECONDS);
                anybody.subscribeWith()
                        .topicFilter("evoloop/lamp/decision")
                        .send()
                        .get(PATIENCE_SECONDS, TimeUnit.SECONDS);
                Runtime.getRuntime().addShutdownHook(new Thread(() -> {
                    broker.close();
                    home.close();
                    wall.close();
                    bypass.close();
                    lamp.close();
                }));
                while (!wall.isUp() || !second.isUp()) {
                    Thread.onSpinWait();
                }
            } catch (Exception failure) {
                throw new IllegalStateException(failure);
            }
        }

        private void publish(String topic, byte[] payload, boolean retain) throws Exception {
            anybody.publishWith()
                    .topic(topic)
                    .payload(payload)
                    .retain(retain)
                    .send()
                    .get(PATIENCE_SECONDS, TimeUnit.SECONDS);
        }

        private void requireAllHear() throws Exception {
            String next = "tick " + number++;
            publish("tick", next.getBytes(StandardCharsets.UTF_8), false);
            await(ticks, next);
            await(ticks, next);
            String nonsense = "no light does " + number;
            publish("evoloop/lamp/light/set", nonsense.getBytes(StandardCharsets.UTF_8), false);
            await(refusals, nonsense);
        }

        private static void await(LinkedBlockingQueue<String> heard, String part) throws InterruptedException {
            String next = heard.poll(PATIENCE_SECONDS, TimeUnit.SECONDS);
            while (next != null && !next.contains(part)) {
                next = heard.poll(PATIENCE_SECONDS, TimeUnit.SECONDS);
            }
            assertThat(next).as(part).isNotNull();
        }
    }

    /** @param bytes the first one chooses the topic, and whether the message is retained; the rest is the payload */
    @MethodSource("seeds")
    @FuzzTest
    void aMessageOfAnyBytesDoesNotPreventLaterOnes(byte[] bytes) throws Exception {
        if (bytes.length == 0) {
            return;
        }
        int choice = bytes[0] & 0xff;
        try (SilentCloseable ours = BugDetectors.allowNetworkConnections()) {
            Parts.PARTS.publish(
                    TOPICS.get(choice % TOPICS.size()),
                    Arrays.copyOfRange(bytes, 1, bytes.length),
                    choice >= Byte.MAX_VALUE);
            Parts.PARTS.requireAllHear();
        }
    }

    static List<byte[]> seeds() {
        return List.of(
                message(0, "switch"),
                message(1, "ON"),
                message(1, "maybe"),
                message(3, "clean_spot"),
                message(4, "night"),
                message(5, "online"),
                message(6, "single"),
                message(7, "toggled"),
                message(8, "switch\nswitch\n"),
                message(8, "\n\n"),
                message(9, "2"),
                message(9, "-99999999999"),
                message(10, "here"),
                message(11, "gone"),
                message(0, "\u0000\ufffe\ud83d"));
    }

    private static byte[] message(int topic, String payload) {
        return ((char) topic + payload).getBytes(StandardCharsets.UTF_8);
    }
}
