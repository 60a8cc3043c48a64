package org.evoloop.mqtt;

import com.hivemq.client.mqtt.MqttGlobalPublishFilter;
import com.hivemq.client.mqtt.datatypes.MqttQos;
import com.hivemq.client.mqtt.mqtt3.Mqtt3AsyncClient;
import com.hivemq.client.mqtt.mqtt3.Mqtt3ClientBuilder;
import com.hivemq.client.mqtt.mqtt3.message.auth.Mqtt3SimpleAuth;
import com.hivemq.client.mqtt.mqtt3.message.auth.Mqtt3SimpleAuthBuilder;
import com.hivemq.client.mqtt.mqtt3.message.publish.Mqtt3Publish;
import java.nio.charset.StandardCharsets;
import java.util.concurrent.CompletableFuture;
import java.util.function.Consumer;
import org.evoloop.mqtt.HiveSession.Setup;
import org.jspecify.annotations.Nullable;

/** A client of MQTT 3.1.1, for brokers that do not know MQTT 5. */
final class HiveMqtt3 implements HiveClient {
    private final Mqtt3AsyncClient client;
    private final @Nullable Message will;

    /** @param incoming receives messages */
    HiveMqtt3(Setup setup, Consumer<Message> incoming, Consumer<Throwable> lost) {
        Mqtt3ClientBuilder builder = HiveClient.common(setup, lost).useMqttVersion3();
        String user = setup.address().user();
        String password = setup.address().password();
        if (user != null) {
            Mqtt3SimpleAuthBuilder.Complete login = Mqtt3SimpleAuth.builder().username(user);
            builder = builder.simpleAuth(
                    password == null
                            ? login.build()
                            : login.password(password.getBytes(StandardCharsets.UTF_8))
                                    .build());
        }
        will = setup.will();
        if (will != null) {
            builder = builder.willPublish(outgoing(will));
        }
        client = builder.buildAsync();
        client.publishes(
                MqttGlobalPublishFilter.ALL,
                publish -> incoming.accept(
                        HiveClient.received(publish.getTopic(), publish.getPayloadAsBytes(), publish.isRetain())));
    }

    private static Mqtt3Publish outgoing(Message message) {
        return Mqtt3Publish.builder()
                .topic(message.topic())
                .payload(message.payload().getBytes(StandardCharsets.UTF_8))
                .qos(MqttQos.AT_LEAST_ONCE)
                .retain(message.kind() == Message.Kind.STATE)
                .build();
    }

    @Override
    public CompletableFuture<?> connect() {
        return client.connectWith()
                .cleanSession(true)
                .keepAlive(KEEP_ALIVE_SECONDS)
                .send();
    }

    @Override
    public CompletableFuture<?> subscribe(String filter) {
        return client.subscribeWith()
                .topicFilter(filter)
                .qos(MqttQos.AT_LEAST_ONCE)
                .send();
    }

    @Override
    public CompletableFuture<?> publish(Message message) {
        return client.publish(outgoing(message));
    }

    /** In this version a broker forgets the will of a client that disconnects, so the client publishes it. */
    @Override
    public CompletableFuture<?> disconnect() {
        return will == null || !isConnected()
                ? client.disconnect()
                : client.publish(outgoing(will)).thenCompose(published -> client.disconnect());
    }

    @Override
    public boolean isConnected() {
        return client.getState().isConnected();
    }
}
