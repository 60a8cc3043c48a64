package org.evoloop.device;

import com.hivemq.client.mqtt.MqttGlobalPublishFilter;
import com.hivemq.client.mqtt.mqtt5.Mqtt5AsyncClient;
import com.hivemq.client.mqtt.mqtt5.Mqtt5Client;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import org.evoloop.imitation.Imitation;
import org.evoloop.mqtt.Mosquitto;

/** An imitated device at a broker, with the topics and the words of a published interface. */
final class MqttImitation implements AutoCloseable {
    private static final long LIMIT_SECONDS = 60;

    private final Mqtt5AsyncClient client;
    private final Imitation device;
    private final Words words;

    /** What a device says and understands. */
    interface Words {
        /** The message that says that it is there, retained. */
        Said present();

        /** The event of the model that a message means; empty if it is not for the device. */
        Optional<String> command(Said message);

        /** Whether a message asks for its state. */
        boolean asks(Said message);

        /** What it says when it is in a state. */
        List<Said> reports(String state);
    }

    /** A message. */
    record Said(String topic, String payload) {}

    MqttImitation(Mosquitto broker, Imitation device, Words words) throws Exception {
        this.device = device;
        this.words = words;
        client = Mqtt5Client.builder()
                .serverHost("127.0.0.1")
                .serverPort(broker.port())
                .buildAsync();
        client.publishes(
                MqttGlobalPublishFilter.ALL,
                publish -> hear(new Said(
                        publish.getTopic().toString(),
                        new String(publish.getPayloadAsBytes(), StandardCharsets.UTF_8))));
        device.reportingTo(state -> words.reports(state).forEach(said -> publish(said, false)));
        client.connect().get(LIMIT_SECONDS, TimeUnit.SECONDS);
        client.subscribeWith().topicFilter("#").send().get(LIMIT_SECONDS, TimeUnit.SECONDS);
        publish(words.present(), true);
    }

    private void hear(Said message) {
        if (words.asks(message)) {
            device.ask();
        } else {
            words.command(message).ifPresent(device::take);
        }
    }

    private void publish(Said said, boolean retained) {
        client.publishWith()
                .topic(said.topic())
                .payload(said.payload().getBytes(StandardCharsets.UTF_8))
                .retain(retained)
                .send();
    }

    @Override
    public void close() {
        device.close();
        if (client.getState().isConnected()) {
            client.disconnect().join();
        }
    }
}
