package org.evoloop.mqtt;

import static org.assertj.core.api.Assertions.assertThat;

import com.hivemq.client.mqtt.MqttGlobalPublishFilter;
import com.hivemq.client.mqtt.mqtt5.Mqtt5AsyncClient;
import com.hivemq.client.mqtt.mqtt5.Mqtt5Client;
import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.TimeUnit;
import org.awaitility.Awaitility;

/** Somebody else at the broker, who hears everything and publishes what they like. */
final class Watcher implements AutoCloseable {
    private static final Duration LIMIT = Duration.ofSeconds(20);

    private final Mqtt5AsyncClient client;
    private final Map<String, String> newest = new ConcurrentHashMap<>();
    private final List<String> heard = new CopyOnWriteArrayList<>();

    Watcher(Mosquitto broker) throws Exception {
        client = Mqtt5Client.builder()
                .serverHost("127.0.0.1")
                .serverPort(broker.port())
                .buildAsync();
        client.publishes(MqttGlobalPublishFilter.ALL, publish -> {
            String topic = publish.getTopic().toString();
            String payload = new String(publish.getPayloadAsBytes(), StandardCharsets.UTF_8);
            newest.put(topic, payload);
            heard.add(topic + " " + payload);
        });
        client.connect().get(10, TimeUnit.SECONDS);
        client.subscribeWith().topicFilter("#").send().get(10, TimeUnit.SECONDS);
    }

    void publish(String topic, String payload, boolean retain) throws Exception {
        client.publishWith()
                .topic(topic)
                .payload(payload.getBytes(StandardCharsets.UTF_8))
                .retain(retain)
                .send()
                .get(10, TimeUnit.SECONDS);
    }

    /** Waits for a message on this topic that contains a text. */
    void awaitHeard(String topic, String part) {
        Awaitility.await()
                .atMost(LIMIT)
                .untilAsserted(
                        () -> assertThat(heard).anyMatch(line -> line.startsWith(topic + " ") && line.contains(part)));
    }

    /** Waits for the newest message on this topic to contain a text. */
    void awaitNewest(String topic, String part) {
        Awaitility.await()
                .atMost(LIMIT)
                .untilAsserted(() -> assertThat(newest.get(topic)).as(topic).contains(part));
    }

    String newest(String topic) {
        return newest.get(topic);
    }

    List<String> heard() {
        return heard;
    }

    @Override
    public void close() {
        if (client.getState().isConnected()) {
            client.disconnect().join();
        }
    }
}
