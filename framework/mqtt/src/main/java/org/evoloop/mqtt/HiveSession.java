package org.evoloop.mqtt;

import com.hivemq.client.mqtt.MqttClientExecutorConfig;
import com.hivemq.client.mqtt.MqttClientSslConfig;
import com.hivemq.client.mqtt.MqttGlobalPublishFilter;
import com.hivemq.client.mqtt.datatypes.MqttQos;
import com.hivemq.client.mqtt.mqtt5.Mqtt5AsyncClient;
import com.hivemq.client.mqtt.mqtt5.Mqtt5Client;
import com.hivemq.client.mqtt.mqtt5.Mqtt5ClientBuilder;
import com.hivemq.client.mqtt.mqtt5.message.auth.Mqtt5SimpleAuth;
import com.hivemq.client.mqtt.mqtt5.message.auth.Mqtt5SimpleAuthBuilder;
import com.hivemq.client.mqtt.mqtt5.message.disconnect.Mqtt5DisconnectReasonCode;
import com.hivemq.client.mqtt.mqtt5.message.publish.Mqtt5Publish;
import java.nio.charset.StandardCharsets;
import java.util.Set;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.function.Consumer;
import org.jspecify.annotations.Nullable;

/**
 * One connection to a broker, from the login to its loss: MQTT 5 with HiveMQ's client, which only this class uses. It
 * starts clean: messages sent to this client in between, such as an old command, are not delivered.
 *
 * <p>Threading: {@link #publish} and {@link #close} for one thread; callbacks come on the client's own and must be
 * quick.
 */
final class HiveSession implements AutoCloseable {
    private static final int ANSWER_SECONDS = 10;
    private static final int GOODBYE_SECONDS = 1;
    private static final int KEEP_ALIVE_SECONDS = 15;
    private static final int MOST_BYTES = 65_536;

    private final BrokerAddress address;
    private final Mqtt5AsyncClient client;
    private final AtomicBoolean gone;

    private HiveSession(BrokerAddress address, Mqtt5AsyncClient client, AtomicBoolean gone) {
        this.address = address;
        this.client = client;
        this.gone = gone;
    }

    /**
     * The settings of a session.
     *
     * @param will the message that the broker publishes when this client is gone; null for none
     * @param filters the topics to subscribe to
     */
    record Setup(
            BrokerAddress address, String client, @Nullable Message will, Set<String> filters) {}

    /**
     * Logs in and subscribes.
     *
     * @param incoming receives messages
     * @param lost receives the reason when the connection is lost, or could not be made
     */
    static HiveSession connect(Setup setup, Consumer<Message> incoming, Consumer<String> lost)
            throws BrokerException, InterruptedException {
        BrokerAddress address = setup.address();
        AtomicBoolean gone = new AtomicBoolean();
        Mqtt5AsyncClient client = builder(setup)
                .addDisconnectedListener(context -> {
                    // The client's own state still says that it is connected.
                    gone.set(true);
                    lost.accept(BrokerFailure.describe(address, context.getCause()));
                })
                .buildAsync();
        HiveSession session = new HiveSession(address, client, gone);
        client.publishes(MqttGlobalPublishFilter.ALL, publish -> incoming.accept(received(publish)));
        try {
            session.await(client.connectWith()
                    .cleanStart(true)
                    .keepAlive(KEEP_ALIVE_SECONDS)
                    .restrictions()
                    .maximumPacketSize(MOST_BYTES)
                    .applyRestrictions()
                    .send());
            for (String filter : setup.filters()) {
                session.await(client.subscribeWith()
                        .topicFilter(filter)
                        .qos(MqttQos.AT_LEAST_ONCE)
                        .send());
            }
            return session;
        } catch (BrokerException | InterruptedException | RuntimeException failure) {
            session.close();
            throw failure;
        }
    }

    private static Mqtt5ClientBuilder builder(Setup setup) {
        BrokerAddress address = setup.address();
        Mqtt5ClientBuilder builder = Mqtt5Client.builder()
                .identifier(setup.client())
                .serverHost(address.host())
                .serverPort(address.port())
                .executorConfig(
                        MqttClientExecutorConfig.builder().nettyThreads(1).build());
        if (address.tls()) {
            builder = builder.sslConfig(MqttClientSslConfig.builder()
                    .trustManagerFactory(address.trust())
                    .build());
        }
        String user = address.user();
        String password = address.password();
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
        return builder;
    }

    private static Mqtt5Publish outgoing(Message message) {
        return Mqtt5Publish.builder()
                .topic(message.topic())
                .payload(message.payload().getBytes(StandardCharsets.UTF_8))
                .qos(MqttQos.AT_LEAST_ONCE)
                .retain(message.kind() == Message.Kind.STATE)
                .build();
    }

    private static Message received(Mqtt5Publish publish) {
        return new Message(
                publish.getTopic().toString(),
                new String(publish.getPayloadAsBytes(), StandardCharsets.UTF_8),
                publish.isRetain() ? Message.Kind.STATE : Message.Kind.COMMAND);
    }

    /** Whether the connection is there. */
    boolean isUp() {
        return !gone.get() && client.getState().isConnected();
    }

    /**
     * Publishes, and waits for the broker's acknowledgement.
     *
     * @return why the broker has refused the message permanently; empty if it has not
     */
    String publish(Message message) throws BrokerException, InterruptedException {
        try {
            answer(client.publish(outgoing(message)));
            return "";
        } catch (ExecutionException failure) {
            String why = BrokerFailure.describe(address, failure.getCause());
            if (BrokerFailure.isDenial(failure.getCause())) {
                return why;
            }
            throw new BrokerException(why);
        }
    }

    private <T> void await(CompletableFuture<T> answer) throws BrokerException, InterruptedException {
        try {
            answer(answer);
        } catch (ExecutionException failure) {
            throw new BrokerException(BrokerFailure.describe(address, failure.getCause()));
        }
    }

    private <T> void answer(CompletableFuture<T> answer)
            throws ExecutionException, BrokerException, InterruptedException {
        try {
            answer.get(ANSWER_SECONDS, TimeUnit.SECONDS);
        } catch (TimeoutException silence) {
            throw new BrokerException(address + " does not answer within " + ANSWER_SECONDS + " s");
        }
    }

    /** Disconnects, if connected; the broker publishes the will. Idempotent. */
    @Override
    public void close() {
        boolean interrupted = Thread.interrupted();
        try {
            client.disconnectWith()
                    .reasonCode(Mqtt5DisconnectReasonCode.DISCONNECT_WITH_WILL_MESSAGE)
                    .send()
                    .get(GOODBYE_SECONDS, TimeUnit.SECONDS);
        } catch (InterruptedException hurry) {
            interrupted = true;
        } catch (ExecutionException | TimeoutException gone) {
            // There was none, or the broker is gone.
        }
        if (interrupted) {
            Thread.currentThread().interrupt();
        }
    }
}
