package org.evoloop.mqtt;

import java.util.Set;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.function.Consumer;
import org.jspecify.annotations.Nullable;

/**
 * One connection to a broker, from the login to its loss: MQTT 5 with HiveMQ's client, or 3.1.1 if the broker does not
 * know it. It starts clean: messages sent to this client in between, such as an old command, are not delivered.
 *
 * <p>Threading: {@link #publish} and {@link #close} for one thread; callbacks come on the client's own and must be
 * quick.
 */
final class HiveSession implements AutoCloseable {
    private static final int ANSWER_SECONDS = 10;
    private static final int GOODBYE_SECONDS = 1;

    private final BrokerAddress address;
    private final HiveClient client;
    private final AtomicBoolean gone;

    private HiveSession(BrokerAddress address, HiveClient client, AtomicBoolean gone) {
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

    /** A client of one version of MQTT. */
    private interface Version {
        HiveClient client(Setup setup, Consumer<Message> incoming, Consumer<Throwable> lost);
    }

    /**
     * Logs in and subscribes.
     *
     * @param incoming receives messages
     * @param lost receives the reason when the connection is lost, or could not be made
     */
    static HiveSession connect(Setup setup, Consumer<Message> incoming, Consumer<String> lost)
            throws BrokerException, InterruptedException {
        try {
            return connect(HiveMqtt5::new, setup, incoming, lost);
        } catch (BrokerException failure) {
            if (!BrokerFailure.mayBeOld(failure.getCause())) {
                throw failure;
            }
            try {
                return connect(HiveMqtt3::new, setup, incoming, lost);
            } catch (BrokerException older) {
                // Only an answer says that it was the version.
                throw BrokerFailure.isAnswer(older.getCause()) ? older : failure;
            }
        }
    }

    private static HiveSession connect(Version version, Setup setup, Consumer<Message> incoming, Consumer<String> lost)
            throws BrokerException, InterruptedException {
        BrokerAddress address = setup.address();
        AtomicBoolean gone = new AtomicBoolean();
        HiveClient client = version.client(setup, incoming, cause -> {
            // The client's own state still says that it is connected.
            gone.set(true);
            lost.accept(BrokerFailure.describe(address, cause));
        });
        HiveSession session = new HiveSession(address, client, gone);
        try {
            session.await(client.connect());
            for (String filter : setup.filters()) {
                session.await(client.subscribe(filter));
            }
            return session;
        } catch (BrokerException | InterruptedException | RuntimeException failure) {
            session.close();
            throw failure;
        }
    }

    /** Whether the connection is there. */
    boolean isUp() {
        return !gone.get() && client.isConnected();
    }

    /**
     * Publishes, and waits for the broker's acknowledgement.
     *
     * @return why the broker has refused the message permanently; empty if it has not
     */
    String publish(Message message) throws BrokerException, InterruptedException {
        try {
            answer(client.publish(message));
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
            throw new BrokerException(BrokerFailure.describe(address, failure.getCause()), failure.getCause());
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
            client.disconnect().get(GOODBYE_SECONDS, TimeUnit.SECONDS);
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
