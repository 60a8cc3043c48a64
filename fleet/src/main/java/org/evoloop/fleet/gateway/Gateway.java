package org.evoloop.fleet.gateway;

import io.micrometer.core.instrument.Gauge;
import io.micrometer.core.instrument.binder.MeterBinder;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import org.apache.kafka.clients.consumer.ConsumerConfig;
import org.apache.kafka.clients.consumer.ConsumerRecord;
import org.apache.kafka.clients.consumer.KafkaConsumer;
import org.apache.kafka.clients.producer.KafkaProducer;
import org.apache.kafka.clients.producer.ProducerConfig;
import org.apache.kafka.clients.producer.ProducerRecord;
import org.apache.kafka.common.KafkaException;
import org.apache.kafka.common.PartitionInfo;
import org.apache.kafka.common.TopicPartition;
import org.apache.kafka.common.errors.ApiException;
import org.apache.kafka.common.errors.AuthenticationException;
import org.apache.kafka.common.errors.AuthorizationException;
import org.apache.kafka.common.errors.ProducerFencedException;
import org.evoloop.fleet.device.Answer;
import org.evoloop.fleet.device.Order;
import org.evoloop.fleet.stream.FleetException;
import org.evoloop.fleet.stream.KafkaCluster;
import org.evoloop.fleet.wire.Reading;
import org.evoloop.fleet.wire.Refusal;
import org.evoloop.fleet.wire.Topic;
import org.evoloop.fleet.wire.Wire;
import org.evoloop.mqtt.BrokerAddress;
import org.evoloop.mqtt.BrokerConnection;
import org.evoloop.mqtt.Message;
import org.evoloop.mqtt.edge.LastCommands;
import org.evoloop.mqtt.edge.Outbox;
import org.evoloop.payload.JsonObject;
import org.evoloop.payload.JsonRecord;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Connects the devices of an MQTT broker to a fleet. Under {@code evoloop/DEVICE/} a device publishes on {@code
 * occurrence} and {@code effect}, and subscribes to {@code command}, {@code state} and {@code kept}; the payloads are
 * the fleet's records.
 *
 * <p>Lifecycle: {@link #start}, then {@link #close}.
 *
 * <p>Threading: thread-safe.
 *
 * @since 0.1
 */
public final class Gateway implements AutoCloseable {
    private static final Logger LOG = LoggerFactory.getLogger(Gateway.class);
    private static final int BATCH = 500;

    /** They are kept in memory, too. A device repeats what is not confirmed. */
    static final int MOST_WAITING = 100_000;

    private static final long PAUSE_MILLIS = 1_000;
    private static final Duration POLL = Duration.ofMillis(200);
    private static final int KAFKA_LIMIT_MILLIS = 10_000;

    private final KafkaCluster cluster;
    private final String fleet;
    private final String name;
    private final Set<String> devices;
    private final Consumer<String> statusListener;
    private final BrokerConnection mqtt;
    private final Outbox outbox;
    private final LastCommands carried;
    /** The highest number stored of each device that numbers its records, since the start. */
    private final Map<String, Long> kept = new ConcurrentHashMap<>();

    private final CountDownLatch closing = new CountDownLatch(1);
    private final List<Thread> threads = new ArrayList<>();
    private final GatewayCounts counts = new GatewayCounts();
    private volatile boolean reachesKafka;
    private volatile String kafka = "Kafka is not reached yet";
    private String reported = "";

    /**
     * A gateway that is not started yet.
     *
     * @param name the name of this gateway, unique in the fleet
     * @param directory the directory for records that the fleet does not have yet
     * @param statusListener receives changes of the links' status
     */
    public Gateway(
            KafkaCluster cluster,
            String fleet,
            String name,
            BrokerAddress mqtt,
            Set<String> devices,
            Path directory,
            Consumer<String> statusListener) {
        this.cluster = cluster;
        this.fleet = fleet;
        this.name = name;
        this.devices = Set.copyOf(devices);
        this.statusListener = statusListener;
        // If the directory was lost, the numbers must be higher than those that the fleet has seen.
        this.outbox = new Outbox(directory, System.currentTimeMillis());
        this.carried = new LastCommands(directory);
        this.mqtt = new BrokerConnection(mqtt, name);
        for (String device : devices) {
            this.mqtt.subscribe(topic(device, "occurrence"), message -> store(Topic.OCCURRENCES, device, message));
            this.mqtt.subscribe(topic(device, "effect"), message -> store(Topic.EFFECTS, device, message));
        }
    }

    private static String topic(String device, String what) {
        return "evoloop/" + device + '/' + what;
    }

    /** Starts without waiting for either broker. */
    public void start() {
        mqtt.open();
        threads.add(new Thread(this::sendAll, "gateway-" + name + "-sender"));
        threads.add(new Thread(this::carryAll, "gateway-" + name + "-commands"));
        threads.forEach(Thread::start);
    }

    // From the devices

    /**
     * Stores a record to be sent, unless an earlier one is missing or too many wait. A record without a time gets the
     * current one.
     */
    private void store(Topic topic, String device, Message message) {
        Optional<JsonRecord> read = read(message.payload());
        String record = read.filter(each -> !each.has("atMillis"))
                .map(each ->
                        each.copy().put("atMillis", System.currentTimeMillis()).toString())
                .orElse(message.payload());
        long number = number(read, "number");
        if (number == 0 && topic == Topic.OCCURRENCES && message.kind() == Message.Kind.STATE) {
            LOG.warn("a retained record on {} is ignored: it comes again with every connection", message.topic());
            return;
        }
        if (isEarlierMissing(device, number, read)) {
            LOG.debug("record {} of {} is not stored: it comes again after those before it", number, device);
            return;
        }
        if (isFull()) {
            LOG.debug("record {} of {} is not stored: {} wait already", number, device, MOST_WAITING);
            return;
        }
        outbox.add(topic.name(), device, record);
        counts.stored.increment();
        acknowledge(device, number);
    }

    /**
     * Whether a record before this one is missing, such as one that was published before this gateway had subscribed:
     * its number is not the next, and the device says that it still has an earlier one to report.
     */
    private boolean isEarlierMissing(String device, long number, Optional<JsonRecord> record) {
        if (number <= kept.getOrDefault(device, 0L) + 1) {
            return false;
        }
        long first = number(record, "first");
        return first > 0 && first < number;
    }

    private boolean isFull() {
        return outbox.size() >= MOST_WAITING;
    }

    /** Acknowledges a numbered record, so that the device need not send it again. */
    private void acknowledge(String device, long number) {
        if (number > 0) {
            kept.merge(device, number, Math::max);
            mqtt.publish(Message.command(
                    topic(device, "kept"),
                    new JsonObject()
                            .put("schema", Wire.SCHEMA)
                            .put("number", number)
                            .toString()));
        }
    }

    /** Nothing if it is not JSON; it will become a dead letter. */
    private static Optional<JsonRecord> read(String record) {
        try {
            return Optional.of(JsonRecord.of(record));
        } catch (IllegalArgumentException unreadable) {
            LOG.debug("a device has sent an invalid record", unreadable);
            return Optional.empty();
        }
    }

    /** A number in the record; 0 if it has none, or is invalid and will become a dead letter. */
    private static long number(Optional<JsonRecord> record, String member) {
        try {
            return record.map(each -> each.number(member, 0)).orElse(0L);
        } catch (IllegalArgumentException unreadable) {
            LOG.debug("a device has sent an invalid record", unreadable);
            return 0;
        }
    }

    private void sendAll() {
        while (isOpen()) {
            try (KafkaProducer<String, byte[]> producer = producer()) {
                producer.initTransactions();
                while (isOpen()) {
                    reachesKafka = true;
                    report("Kafka can be reached");
                    send(producer, outbox.first(BATCH, POLL.toMillis()));
                }
            } catch (KafkaException | FleetException unreachable) {
                reachesKafka = false;
                report(trouble(unreachable));
                LOG.debug("the records remain stored", unreachable);
                pause();
            } catch (UncheckedIOException unwritable) {
                failedToWrite(unwritable);
            } catch (InterruptedException closed) {
                return;
            }
        }
    }

    private String trouble(RuntimeException failure) {
        Throwable cause = failure instanceof ApiException || failure.getCause() == null ? failure : failure.getCause();
        if (cause instanceof ProducerFencedException) {
            return "another gateway has the name '" + name + "'; give each its own with --gateway";
        }
        boolean refused = cause instanceof AuthenticationException || cause instanceof AuthorizationException;
        return (refused ? "Kafka refuses this gateway (" + cause.getMessage() + ")" : "Kafka is not reached")
                + "; the devices' records are " + (isFull() ? "no longer stored" : "stored");
    }

    /** As on a full disk: it is tried again, since there may be room later. */
    private void failedToWrite(UncheckedIOException unwritable) {
        LOG.error("the journal cannot be written; it is tried again: {}", unwritable.getMessage());
        pause();
    }

    /** Sends all or none: if only a later record arrived, the earlier one would be taken for a repetition. */
    private void send(KafkaProducer<String, byte[]> producer, List<Outbox.Entry> batch) {
        if (batch.isEmpty()) {
            return;
        }
        producer.beginTransaction();
        for (Outbox.Entry entry : batch) {
            byte[] record = numbered(entry).getBytes(StandardCharsets.UTF_8);
            var sent = producer.send(
                    new ProducerRecord<>(Topic.valueOf(entry.topic()).of(fleet), entry.device(), record));
            LOG.trace("sent {}", sent);
        }
        producer.commitTransaction();
        outbox.sent(batch.get(batch.size() - 1).number());
        counts.sent.add(batch.size());
    }

    private static String numbered(Outbox.Entry entry) {
        Optional<JsonRecord> record =
                entry.topic().equals(Topic.OCCURRENCES.name()) ? read(entry.record()) : Optional.empty();
        return record.filter(each -> !each.has("number"))
                .map(each -> each.copy().put("number", entry.number()).toString())
                .orElse(entry.record());
    }

    private KafkaProducer<String, byte[]> producer() {
        return cluster.producer(Map.of(
                ProducerConfig.TRANSACTIONAL_ID_CONFIG,
                fleet + "-gateway-" + name,
                ProducerConfig.MAX_BLOCK_MS_CONFIG,
                KAFKA_LIMIT_MILLIS,
                ProducerConfig.DELIVERY_TIMEOUT_MS_CONFIG,
                KAFKA_LIMIT_MILLIS,
                ProducerConfig.REQUEST_TIMEOUT_MS_CONFIG,
                KAFKA_LIMIT_MILLIS / 2));
    }

    // To the devices

    private void carryAll() {
        while (isOpen()) {
            try (KafkaConsumer<String, byte[]> consumer = consumer()) {
                PresentStates present = assign(consumer);
                while (isOpen()) {
                    for (ConsumerRecord<String, byte[]> record : consumer.poll(POLL)) {
                        if (devices.contains(record.key())) {
                            carry(record, present);
                        }
                    }
                    present.publishOnceRead(consumer);
                    consumer.commitAsync();
                }
            } catch (KafkaException | FleetException unreachable) {
                LOG.debug("no commands can be fetched", unreachable);
                pause();
            } catch (UncheckedIOException unwritable) {
                // The command is fetched again.
                failedToWrite(unwritable);
            } catch (InterruptedException closed) {
                return;
            }
        }
    }

    /** Begins with the first command not fetched yet, and with all states. */
    private PresentStates assign(KafkaConsumer<String, byte[]> consumer) {
        List<TopicPartition> states = partitions(consumer, Topic.STATES);
        List<TopicPartition> all = new ArrayList<>(states);
        all.addAll(partitions(consumer, Topic.COMMANDS));
        consumer.assign(all);
        consumer.seekToBeginning(states);
        return new PresentStates(consumer.endOffsets(states));
    }

    /**
     * The states that were in Kafka before this gateway: the MQTT broker may have lost them, and a device may be new at this
     * gateway. Only the last of each device is published.
     */
    private final class PresentStates {
        private final Map<TopicPartition, Long> unread;
        private final Map<String, String> last = new HashMap<>();

        PresentStates(Map<TopicPartition, Long> ends) {
            unread = new HashMap<>(ends);
        }

        void add(String device, String state) {
            if (unread.isEmpty()) {
                mqtt.publish(Message.state(topic(device, "state"), state));
            } else {
                last.put(device, state);
            }
        }

        void publishOnceRead(KafkaConsumer<String, byte[]> consumer) {
            unread.entrySet().removeIf(each -> consumer.position(each.getKey()) >= each.getValue());
            if (unread.isEmpty()) {
                last.forEach(this::add);
                last.clear();
            }
        }
    }

    private void carry(ConsumerRecord<String, byte[]> record, PresentStates present) throws InterruptedException {
        if (record.topic().equals(Topic.STATES.of(fleet))) {
            present.add(record.key(), record.value() == null ? "" : Wire.text(record.value()));
            return;
        }
        try {
            Order order = Reading.of(record.value()).order();
            if (carried.take(record.key(), order.sequence())) {
                carry(record.key(), order, Wire.text(record.value()));
            }
        } catch (Refusal unreadable) {
            LOG.error("a command for {} is skipped: {}", record.key(), unreadable.detail());
        }
    }

    private void carry(String device, Order order, String text) throws InterruptedException {
        mqtt.awaitRoom();
        long now = System.currentTimeMillis();
        if (Wire.millis(order.deadlineNanos()) < now) {
            failed(device, order, "the command arrived after its deadline", now);
        } else if (mqtt.isUp()) {
            mqtt.publish(Message.command(topic(device, "command"), text));
            counts.published.increment();
        } else {
            failed(device, order, "the device cannot be reached: " + mqtt.describe(), now);
        }
    }

    private void failed(String device, Order order, String why, long nowMillis) {
        counts.failed.increment();
        Answer answer = new Answer(order.sequence(), Answer.Outcome.FAILED, why, null, Wire.nanos(nowMillis));
        outbox.add(Topic.EFFECTS.name(), device, Wire.text(Wire.effect(answer)));
    }

    private KafkaConsumer<String, byte[]> consumer() {
        return cluster.consumer(Map.of(
                ConsumerConfig.GROUP_ID_CONFIG,
                fleet + "-gateway-" + name,
                ConsumerConfig.ISOLATION_LEVEL_CONFIG,
                "read_committed",
                ConsumerConfig.ENABLE_AUTO_COMMIT_CONFIG,
                false,
                ConsumerConfig.DEFAULT_API_TIMEOUT_MS_CONFIG,
                KAFKA_LIMIT_MILLIS,
                ConsumerConfig.AUTO_OFFSET_RESET_CONFIG,
                "earliest"));
    }

    private List<TopicPartition> partitions(KafkaConsumer<String, byte[]> consumer, Topic topic) {
        List<TopicPartition> all = new ArrayList<>();
        for (PartitionInfo each : consumer.partitionsFor(topic.of(fleet))) {
            all.add(new TopicPartition(each.topic(), each.partition()));
        }
        return all;
    }

    // Status

    /** The number of records that wait for a connection to the fleet. */
    public int waiting() {
        return outbox.size();
    }

    /** Whether the devices' broker is connected. */
    public boolean reachesDevices() {
        return mqtt.isUp();
    }

    /** Whether records can be sent to the fleet. */
    public boolean reachesKafka() {
        return reachesKafka;
    }

    /** The status of both connections, for people. */
    public String describe() {
        return kafka + "; records waiting: " + outbox.size() + "; MQTT: " + devicesStatus();
    }

    /**
     * Its metrics: {@code evoloop.gateway.records} and {@code evoloop.gateway.commands} since its start, and whether it
     * reaches both brokers.
     */
    public MeterBinder metrics() {
        return registry -> {
            counts.bindTo(registry);
            Gauge.builder("evoloop.gateway.waiting", this, Gateway::waiting)
                    .description("Records that wait for a connection to the fleet")
                    .register(registry);
            Gauge.builder("evoloop.gateway.kafka.up", this, gateway -> gateway.reachesKafka() ? 1 : 0)
                    .description("Whether Kafka is reached")
                    .register(registry);
            Gauge.builder("evoloop.gateway.mqtt.up", this, gateway -> gateway.reachesDevices() ? 1 : 0)
                    .description("Whether the devices' broker is connected")
                    .register(registry);
        };
    }

    private String devicesStatus() {
        return mqtt.isUp() ? "the devices' broker can be reached" : mqtt.describe();
    }

    private synchronized void report(String ofKafka) {
        kafka = ofKafka;
        String status = ofKafka + "; " + devicesStatus();
        if (!status.equals(reported)) {
            reported = status;
            statusListener.accept(describe());
        }
    }

    private boolean isOpen() {
        return closing.getCount() > 0;
    }

    private void pause() {
        try {
            if (closing.await(PAUSE_MILLIS, TimeUnit.MILLISECONDS)) {
                LOG.debug("closing");
            }
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }

    @Override
    public void close() {
        closing.countDown();
        mqtt.close();
        for (Thread each : threads) {
            try {
                each.join(3L * KAFKA_LIMIT_MILLIS);
            } catch (InterruptedException e) {
                Thread.currentThread().interrupt();
            }
        }
        outbox.close();
        carried.close();
    }
}
