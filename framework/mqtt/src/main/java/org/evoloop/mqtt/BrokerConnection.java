package org.evoloop.mqtt;

import java.time.Duration;
import java.time.Instant;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicLong;
import java.util.function.BooleanSupplier;
import java.util.function.Consumer;
import org.evoloop.converter.DeviceLink;
import org.evoloop.payload.report.Aftermath;
import org.evoloop.payload.report.Turns;
import org.evoloop.time.Attempts;
import org.evoloop.time.Threads;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * A connection to a broker that reconnects whenever it is lost, with pauses of 250 ms to 30 s. After each connect every
 * state is published again ({@link Message.Kind#STATE}), so the current states are complete even if the broker has
 * forgotten them. A fault is logged once, until it changes or ends.
 *
 * <p>Lifecycle: {@link #will} and {@link #subscribe}, then {@link #open}, which does not wait for the broker; {@link
 * #close}.
 *
 * <p>Threading: all methods may be called from any thread; only {@link #awaitRoom} and {@link #close} wait. Consumers
 * are called on a thread of the client, one at a time, and must be quick.
 *
 * @since 0.1
 */
public final class BrokerConnection implements DeviceLink, AutoCloseable {
    private static final Logger LOG = LoggerFactory.getLogger(BrokerConnection.class);
    private static final Duration END_LIMIT = Duration.ofSeconds(3);

    private final BrokerAddress address;
    private final String client;
    private final Map<String, Deque<Consumer<Message>>> consumers = new LinkedHashMap<>();
    private final Map<String, Aftermath> aftermaths = new LinkedHashMap<>();
    private final List<Runnable> whenLost = new CopyOnWriteArrayList<>();
    private final Outbox outbox = new Outbox();
    private final Attempts attempts = new Attempts();
    private final CountDownLatch closed = new CountDownLatch(1);
    private final Set<String> deniedTopics = new HashSet<>();
    private final Set<String> failedTopics = ConcurrentHashMap.newKeySet();
    private @Nullable Message will;
    private @Nullable Thread thread;
    private volatile @Nullable HiveSession session;
    private volatile boolean closing;
    private volatile @Nullable Instant downSince = Instant.now();
    private volatile String trouble;
    private final AtomicLong connects = new AtomicLong();
    private final Turns turns = new Turns();

    /** @param client the client's identifier at the broker; if two have the same, it disconnects the older */
    public BrokerConnection(BrokerAddress address, String client) {
        this.address = address;
        this.client = client;
        this.trouble = address + " has not been reached yet";
    }

    /** Sets the message that the broker publishes when this client is gone, however it ended; before {@link #open}. */
    public synchronized void will(Message message) {
        will = message;
    }

    /** Sets an action for each time that a connection has ended, run before the next one; before {@link #open}. */
    synchronized void onLost(Runnable action) {
        whenLost.add(action);
    }

    /**
     * Calls {@code consumer} with each message on this topic; before {@link #open}. A message that the broker had
     * retained is a {@link Message.Kind#STATE}, any other a {@link Message.Kind#COMMAND}. If {@code consumer} throws, that
     * is logged the first time, and later messages still arrive.
     *
     * Several consumers of a topic are called in the order in which they were added.
     *
     * @param topic the topic, without wildcards
     * @throws IllegalStateException if it is open
     */
    public synchronized void subscribe(String topic, Consumer<Message> consumer) {
        consumersOf(topic).addLast(consumer);
    }

    /** As {@link #subscribe}; {@code consumer} is called before those that are there. */
    synchronized void subscribeFirst(String topic, Consumer<Message> consumer) {
        consumersOf(topic).addFirst(consumer);
    }

    /** What is known of commands to the device that reports its state on this topic; before {@link #open}. */
    synchronized Aftermath aftermath(String topic) {
        return aftermaths.computeIfAbsent(topic, first -> {
            Aftermath made = new Aftermath(turns);
            subscribeFirst(topic, message -> made.receives(message.report()));
            return made;
        });
    }

    /** In which messages are received; what a timer says of them is said there, too. */
    Turns turns() {
        return turns;
    }

    private Deque<Consumer<Message>> consumersOf(String topic) {
        if (thread != null) {
            throw new IllegalStateException(
                    "the topic " + topic + " of " + address + " must be subscribed to before the connection is opened");
        }
        return consumers.computeIfAbsent(topic, unused -> new ArrayDeque<>());
    }

    /** Starts connecting; does nothing if it was opened before. */
    public synchronized void open() {
        if (thread == null) {
            thread = new Thread(this::run, "mqtt-" + client);
            thread.setDaemon(true);
            thread.start();
        }
    }

    /** Publishes a message as soon as its {@linkplain Message.Kind kind} allows. */
    public void publish(Message message) {
        if (message.kind() != Message.Kind.COMMAND || isUp()) {
            outbox.put(message);
        }
    }

    /**
     * Waits until there is room for more messages without losing others, or until the connection is lost; for callers
     * that publish faster than the broker takes messages.
     */
    public void awaitRoom() throws InterruptedException {
        outbox.awaitRoom(() -> isUp() && !closing);
    }

    /** Publishes every state again. */
    public void republish() {
        outbox.republish();
    }

    /** The number of connects so far. */
    public long connects() {
        return connects.get();
    }

    /** The number of messages lost because too many waited. */
    public long lost() {
        return outbox.lost();
    }

    private void run() {
        try {
            while (!closing) {
                connectAndServe();
                if (!closing) {
                    // Ends at once with close(), which must not wait for the pause.
                    closed.await(attempts.pause().toMillis(), TimeUnit.MILLISECONDS);
                }
            }
        } catch (InterruptedException end) {
            // It is being closed.
        }
    }

    private void connectAndServe() throws InterruptedException {
        HiveSession.Setup setup;
        synchronized (this) {
            setup = new HiveSession.Setup(address, client, will, Set.copyOf(consumers.keySet()));
        }
        try (HiveSession made = HiveSession.connect(setup, this::receive, this::lost)) {
            connects.incrementAndGet();
            session = made;
            downSince = null;
            outbox.republish();
            serve(made);
        } catch (BrokerException failure) {
            note(String.valueOf(failure.getMessage()));
        } finally {
            session = null;
            if (downSince == null) {
                downSince = Instant.now();
            }
            // After the session is gone from the field: a command put now sees that the connection is down and is not
            // kept.
            outbox.discardCommands();
            outbox.wake();
            whenLost.forEach(Runnable::run);
        }
    }

    private void serve(HiveSession made) throws BrokerException, InterruptedException {
        judge(made);
        BooleanSupplier worthIt = () -> made.isUp() && !(closing && outbox.isEmpty());
        for (Message next = outbox.take(worthIt); next != null; next = outbox.take(worthIt)) {
            try {
                String denied = made.publish(next);
                if (!denied.isEmpty() && deniedTopics.add(next.topic())) {
                    LOG.warn("{}; the topic is {}", denied, next.topic());
                }
            } catch (BrokerException | InterruptedException failure) {
                // It may have reached the broker: a state may be published twice, and an event, but a command never.
                outbox.giveBack(next);
                throw failure;
            }
            judge(made);
        }
    }

    /** All is well once every message has reached the broker. */
    private void judge(HiveSession made) {
        if (outbox.isEmpty() && made.isUp()) {
            trouble = "";
            if (attempts.succeeded(System.nanoTime())) {
                LOG.info("{} has everything", address);
            }
        }
    }

    private void lost(String why) {
        if (session != null && !closing) {
            note(why);
        }
        outbox.wake();
    }

    private void note(String why) {
        trouble = why;
        if (attempts.failed(why, System.nanoTime())) {
            LOG.warn("{}; trying to connect again", why);
        }
    }

    private void receive(Message message) {
        List<Consumer<Message>> all;
        synchronized (this) {
            // Handed over without the lock: a consumer may publish, and may even close the connection.
            all = List.copyOf(consumers.getOrDefault(message.topic(), new ArrayDeque<>()));
        }
        if (!closing) {
            turns.take(() -> all.forEach(consumer -> hand(message, consumer)));
        }
    }

    private void hand(Message message, Consumer<Message> consumer) {
        try {
            consumer.accept(message);
        } catch (RuntimeException wrong) {
            // Otherwise the client would stop calling consumers.
            if (failedTopics.add(message.topic())) {
                LOG.warn("a message on {} could not be handled", message.topic(), wrong);
            }
        }
    }

    @Override
    public boolean isUp() {
        HiveSession now = session;
        return now != null && now.isUp();
    }

    @Override
    public Optional<Instant> downSince() {
        return Optional.ofNullable(downSince);
    }

    @Override
    public String describe() {
        String wrong = trouble;
        return isUp() || wrong.isEmpty() ? address.toString() : wrong;
    }

    /** Publishes the waiting messages, if the broker is connected, then disconnects and ends. Idempotent. */
    @Override
    public void close() {
        closing = true;
        closed.countDown();
        outbox.wake();
        Thread running;
        synchronized (this) {
            running = thread;
        }
        if (running == null) {
            return;
        }
        // Up, it is given time to publish what waits; down, it may be in the middle of a long attempt to connect.
        if (!isUp()) {
            running.interrupt();
        }
        if (!Threads.join(running, END_LIMIT)) {
            running.interrupt();
            LOG.warn("{} did not take everything within {} s", address, END_LIMIT.toSeconds());
        }
    }
}
