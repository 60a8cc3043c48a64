package org.evoloop.mqtt;

import com.hivemq.client.mqtt.MqttClient;
import com.hivemq.client.mqtt.MqttClientBuilder;
import com.hivemq.client.mqtt.MqttClientExecutorConfig;
import com.hivemq.client.mqtt.MqttClientSslConfig;
import com.hivemq.client.mqtt.datatypes.MqttTopic;
import java.nio.charset.StandardCharsets;
import java.util.concurrent.CompletableFuture;
import java.util.function.Consumer;
import org.evoloop.mqtt.HiveSession.Setup;

/**
 * What a session needs of a client of one version of MQTT.
 *
 * <p>Threading: thread-safe; nothing waits.
 */
interface HiveClient {
    /** After this time without messages the broker is asked whether it is there. */
    int KEEP_ALIVE_SECONDS = 15;

    CompletableFuture<?> connect();

    CompletableFuture<?> subscribe(String filter);

    /** Ends when the broker has acknowledged the message. */
    CompletableFuture<?> publish(Message message);

    /** Disconnects; the broker publishes the will. */
    CompletableFuture<?> disconnect();

    boolean isConnected();

    /** A message from the broker. */
    static Message received(MqttTopic topic, byte[] payload, boolean retained) {
        return new Message(
                topic.toString(),
                new String(payload, StandardCharsets.UTF_8),
                retained ? Message.Kind.STATE : Message.Kind.COMMAND);
    }

    /**
     * The settings that both versions have in common.
     *
     * @param lost receives the reason when the connection is lost, or could not be made
     */
    static MqttClientBuilder common(Setup setup, Consumer<Throwable> lost) {
        BrokerAddress address = setup.address();
        MqttClientBuilder builder = MqttClient.builder()
                .identifier(setup.client())
                .serverHost(address.host())
                .serverPort(address.port())
                .executorConfig(
                        MqttClientExecutorConfig.builder().nettyThreads(1).build())
                .addDisconnectedListener(context -> lost.accept(context.getCause()));
        return address.tls()
                ? builder.sslConfig(MqttClientSslConfig.builder()
                        .trustManagerFactory(address.trust())
                        .build())
                : builder;
    }
}
