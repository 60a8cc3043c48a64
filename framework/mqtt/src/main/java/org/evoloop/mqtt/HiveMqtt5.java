package org.evoloop.mqtt;

import com.hivemq.client.mqtt.MqttGlobalPublishFilter;
import com.hivemq.client.mqtt.datatypes.MqttQos;
import com.hivemq.client.mqtt.mqtt5.Mqtt5AsyncClient;
import com.hivemq.client.mqtt.mqtt5.Mqtt5ClientBuilder;
import com.hivemq.client.mqtt.mqtt5.message.auth.Mqtt5SimpleAuth;
import com.hivemq.client.mqtt.mqtt5.message.auth.Mqtt5SimpleAuthBuilder;
import com.hivemq.client.mqtt.mqtt5.message.disconnect.Mqtt5DisconnectReasonCode;
import com.hivemq.client.mqtt.mqtt5.message.publish.Mqtt5Publish;
import java.nio.charset.StandardCharsets;
import java.util.concurrent.CompletableFuture;
import java.util.function.Consumer;
import org.evoloop.mqtt.HiveSession.Setup;

/** A client of MQTT 5. */
final class HiveMqtt5 implements HiveClient {
    private static final int MOST_BYTES = 65_536;

    private final Mqtt5AsyncClient client;

    /** @param incoming receives messages */
    HiveMqtt5(Setup setup, Consumer<Message> incoming, Consumer<Throwable> lost) {
        Mqtt5ClientBuilder builder = HiveClient.common(setup, lost).useMqttVersion5();
        String user = setup.address().user();
        String password = setup.address().password();
        if (user != null) {
            Mqtt5SimpleAuthBuilder.Complete login = Mqtt5SimpleAuth.builder().username(user);
            builder = builder.simpleAuth(
                    password == null
                            ? login.build()
                            : login.password(password.getBytes(StandardCharsets.UTF_8))
                                    .build());
        }
        Message will = setup.will();
        if (will != null) {
            builder = builder.willPublish(outgoing(will));
        }
        client = builder.buildAsync();
        client.publishes(
                MqttGlobalPublishFilter.ALL,
                publish -> incoming.accept(
                        HiveClient.received(publish.getTopic(), publish.getPayloadAsBytes(), publish.isRetain())));
    }

    private static Mqtt5Publish outgoing(Message message) {
        return Mqtt5Publish.builder()
                .topic(message.topic())
                .payload(message.payload().getBytes(StandardCharsets.UTF_8))
                .qos(MqttQos.AT_LEAST_ONCE)
                .retain(message.kind() == Message.Kind.STATE)
                .build();
    }

    @Override
    public CompletableFuture<?> connect() {
        return client.connectWith()
                .cleanStart(true)
                .keepAlive(KEEP_ALIVE_SECONDS)
                .restrictions()
                .maximumPacketSize(MOST_BYTES)
                .applyRestrictions()
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

    @Override
    public CompletableFuture<?> disconnect() {
        return client.disconnectWith()
                .reasonCode(Mqtt5DisconnectReasonCode.DISCONNECT_WITH_WILL_MESSAGE)
                .send();
    }

    @Override
    public boolean isConnected() {
        return client.getState().isConnected();
    }
}
