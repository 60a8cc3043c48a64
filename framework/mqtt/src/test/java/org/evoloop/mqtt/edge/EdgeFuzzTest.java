package org.evoloop.mqtt.edge;

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
import java.time.Instant;
import java.time.InstantSource;
import java.util.Arrays;
import java.util.List;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import org.evoloop.RecordingExecute;
import org.evoloop.converter.edge.EdgeShell;
import org.evoloop.loop.LoopConfig;
import org.evoloop.mqtt.BrokerAddress;
import org.evoloop.mqtt.Mosquitto;
import org.evoloop.payload.JsonRecord;
import org.evoloop.time.SystemClock;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.provider.MethodSource;

/**
 * Whatever is published on the topics from which a device of a fleet gets its commands and states, the next command is
 * carried out. The broker is Mosquitto.
 */
@Timeout(60)
class EdgeFuzzTest {
    private static final int PATIENCE_SECONDS = 20;
    private static final Instant NOW = Instant.parse("2026-11-26T12:00:00Z");
    private static final List<String> TOPICS = List.of("command", "state", "kept");

    /** A device carries out no command with a lower sequence number than one before; this leaves room for many. */
    private static final long HIGHEST = 1L << 52;

    /** Shared by all inputs, so that anything that one message leaves behind affects the next. */
    private static final class Parts {
        private static final Parts PARTS = new Parts();

        private final Mqtt5AsyncClient gateway;
        private final LinkedBlockingQueue<String> effects = new LinkedBlockingQueue<>();
        private long sequence;

        private Parts() {
            try (SilentCloseable ours = BugDetectors.allowNetworkConnections()) {
                Path directory = Files.createTempDirectory("evoloop-fuzz");
                Mosquitto broker = new Mosquitto(directory).start();
                SystemClock clock = new SystemClock();
                LinkedBlockingQueue<String> link = new LinkedBlockingQueue<>();
                EdgeDevice edge = new EdgeDevice(
                        "lamp",
                        BrokerAddress.parse(broker.url()),
                        directory.resolve("edge"),
                        clock,
                        InstantSource.fixed(NOW),
                        link::add);
                EdgeShell shell = new EdgeShell(LoopConfig.defaults("lamp", clock), EdgeDeviceTest.knowledge(), edge);
                shell.addExecute(new RecordingExecute("Bulb", "switch"));
                gateway = Mqtt5Client.builder()
                        .serverHost("127.0.0.1")
                        .serverPort(broker.port())
                        .buildAsync();
                gateway.publishes(
                        MqttGlobalPublishFilter.ALL,
                        publish -> effects.add(new String(publish.getPayloadAsBytes(), StandardCharsets.UTF_8)));
                gateway.connect().get(PATIENCE_SECONDS, TimeUnit.SECONDS);
                gateway.subscribeWith()
                        .topicFilter("evoloop/lamp/effect")
                        .send()
                        .get(PATIENCE_SECONDS, TimeUnit.SECONDS);
                shell.open();
                edge.open(shell);
                Runtime.getRuntime().addShutdownHook(new Thread(() -> {
                    edge.close();
                    shell.close();
                    broker.close();
                    clock.close();
                }));
                String how = "";
                while (!how.startsWith("the gateway's broker can be reached")) {
                    how = String.valueOf(link.poll(PATIENCE_SECONDS, TimeUnit.SECONDS));
                }
            } catch (Exception failure) {
                throw new IllegalStateException(failure);
            }
        }

        private void publish(String topic, byte[] payload) throws Exception {
            gateway.publishWith()
                    .topic("evoloop/lamp/" + topic)
                    .payload(payload)
                    .send()
                    .get(PATIENCE_SECONDS, TimeUnit.SECONDS);
        }

        private void requireObeys() throws Exception {
            String next = "{\"sequence\":" + ++sequence + ",\"kind\":\"locate\",\"deadlineMillis\":"
                    + NOW.toEpochMilli() + "}";
            publish("command", next.getBytes(StandardCharsets.UTF_8));
            String effect = effects.poll(PATIENCE_SECONDS, TimeUnit.SECONDS);
            while (effect != null && !effect.contains("\"sequence\":" + sequence + ",\"outcome\":\"sent\"")) {
                effect = effects.poll(PATIENCE_SECONDS, TimeUnit.SECONDS);
            }
            assertThat(effect).isNotNull();
            String kept = "{\"number\":" + JsonRecord.of(String.valueOf(effect)).number("number", 0) + "}";
            publish("kept", kept.getBytes(StandardCharsets.UTF_8));
        }
    }

    /** @param bytes the first one chooses the topic; the rest is the payload */
    @MethodSource("seeds")
    @FuzzTest
    void aMessageOfAnyBytesDoesNotPreventTheNextCommand(byte[] bytes) throws Exception {
        if (bytes.length == 0) {
            return;
        }
        byte[] payload = Arrays.copyOfRange(bytes, 1, bytes.length);
        String text = new String(payload, StandardCharsets.UTF_8);
        long sequence = sequenceOf(text);
        if (sequence > HIGHEST) {
            return;
        }
        Parts parts = Parts.PARTS;
        parts.sequence = Math.max(parts.sequence, sequence);
        try (SilentCloseable ours = BugDetectors.allowNetworkConnections()) {
            parts.publish(TOPICS.get((bytes[0] & 0xff) % TOPICS.size()), payload);
            parts.requireObeys();
        }
    }

    private static long sequenceOf(String payload) {
        try {
            return new Received(payload).members().number("sequence", 0);
        } catch (IllegalArgumentException unreadable) {
            return 0;
        }
    }

    static List<byte[]> seeds() {
        return List.of(
                message(
                        0,
                        "{\"schema\":1,\"sequence\":7,\"kind\":\"send\",\"deadlineMillis\":1e14,\"event\":\"switch\",\"from\":\"off\","
                                + "\"to\":\"on\",\"visit\":1,\"function\":false,\"values\":{\"by\":\"me\",\"level\":0.5}}"),
                message(0, "{\"sequence\":9,\"kind\":\"run\",\"deadlineMillis\":1e14,\"effect\":\" \"}"),
                message(
                        0,
                        "{\"sequence\":11,\"kind\":\"send\",\"deadlineMillis\":1e14,\"event\":\"\",\"from\":\"\",\"to\":\"\"}"),
                message(
                        1,
                        "{\"schema\":1,\"device\":\"on\",\"system\":\"wait\",\"visit\":4,\"function\":true,\"settled\":true,"
                                + "\"sequence\":0,\"from\":\"on\",\"by\":\"switch\",\"timersMillis\":{\"x\":[1]}}"),
                message(1, "{\"device\":\" \",\"system\":\"nowhere\"}"),
                message(1, ""),
                message(2, "{\"number\":17}"),
                message(2, "{\"number\":\"\\u0041\\n\"}"));
    }

    private static byte[] message(int topic, String payload) {
        return ((char) topic + payload).getBytes(StandardCharsets.UTF_8);
    }
}
