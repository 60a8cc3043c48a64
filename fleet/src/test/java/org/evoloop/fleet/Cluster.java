package org.evoloop.fleet;

import java.io.IOException;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.function.Predicate;
import org.apache.kafka.clients.consumer.ConsumerConfig;
import org.apache.kafka.clients.consumer.ConsumerRecord;
import org.apache.kafka.clients.consumer.KafkaConsumer;
import org.apache.kafka.clients.producer.KafkaProducer;
import org.apache.kafka.clients.producer.ProducerConfig;
import org.apache.kafka.clients.producer.ProducerRecord;
import org.apache.kafka.common.PartitionInfo;
import org.apache.kafka.common.TopicPartition;
import org.apache.kafka.common.serialization.ByteArrayDeserializer;
import org.apache.kafka.common.serialization.ByteArraySerializer;
import org.apache.kafka.common.serialization.StringDeserializer;
import org.apache.kafka.common.serialization.StringSerializer;
import org.apache.kafka.common.utils.Utils;
import org.evoloop.fleet.stream.FleetTopics;
import org.evoloop.fleet.wire.Topic;

/** Writes and reads a fleet's topics at a broker. */
public final class Cluster implements AutoCloseable {
    private static final Duration LIMIT = Duration.ofSeconds(90);

    private final String fleet;
    private final int partitions;
    private final KafkaProducer<String, byte[]> producer;
    private final KafkaConsumer<String, byte[]> consumer;
    private final TopicRecords records = new TopicRecords();

    /** A fresh fleet at the shared broker. */
    public static Cluster fresh(int partitions) throws IOException {
        return new Cluster(Brokers.shared(), Brokers.freshFleet(), partitions);
    }

    public Cluster(String bootstrap, String fleet, int partitions) {
        this.fleet = fleet;
        this.partitions = partitions;
        try (FleetTopics topics = new FleetTopics(bootstrap, fleet)) {
            topics.create(partitions);
            topics.check();
        }
        producer = new KafkaProducer<>(
                Map.of(ProducerConfig.BOOTSTRAP_SERVERS_CONFIG, bootstrap, ProducerConfig.LINGER_MS_CONFIG, 5),
                new StringSerializer(),
                new ByteArraySerializer());
        consumer = new KafkaConsumer<>(
                Map.of(
                        ConsumerConfig.BOOTSTRAP_SERVERS_CONFIG, bootstrap,
                        ConsumerConfig.ISOLATION_LEVEL_CONFIG, "read_committed",
                        ConsumerConfig.AUTO_OFFSET_RESET_CONFIG, "earliest"),
                new StringDeserializer(),
                new ByteArrayDeserializer());
        List<TopicPartition> all = new ArrayList<>();
        for (Topic topic : List.of(Topic.COMMANDS, Topic.DECISIONS, Topic.STATES, Topic.DEAD_LETTERS, Topic.ROLLOUTS)) {
            for (PartitionInfo each : consumer.partitionsFor(topic.of(fleet))) {
                all.add(new TopicPartition(each.topic(), each.partition()));
            }
        }
        consumer.assign(all);
    }

    public String fleet() {
        return fleet;
    }

    public int partitionOf(String device) {
        return Utils.toPositive(Utils.murmur2(Utils.utf8(device))) % partitions;
    }

    public void write(Topic topic, String key, byte[] record) {
        producer.send(new ProducerRecord<>(topic.of(fleet), key, record));
    }

    public void write(Topic topic, String key, byte[] record, long timestamp) {
        producer.send(new ProducerRecord<>(topic.of(fleet), null, timestamp, key, record));
    }

    public void flush() {
        producer.flush();
    }

    /** All records read so far. */
    public TopicRecords records() {
        return records;
    }

    /** Reads until the records satisfy {@code enough}. */
    public TopicRecords readUntil(Predicate<TopicRecords> enough) {
        long last = System.nanoTime();
        while (!enough.test(records)) {
            if (!read(Duration.ofMillis(200)).isEmpty()) {
                last = System.nanoTime();
            } else if (System.nanoTime() - last > LIMIT.toNanos()) {
                throw new AssertionError("nothing came for " + LIMIT + " after " + records.size() + " records");
            }
        }
        return records;
    }

    /** Reads the records that arrive within {@code limit}. */
    public List<ConsumerRecord<String, byte[]>> read(Duration limit) {
        List<ConsumerRecord<String, byte[]>> read = new ArrayList<>();
        for (ConsumerRecord<String, byte[]> record : consumer.poll(limit)) {
            records.add(topicOf(record), record.key(), record.value());
            read.add(record);
        }
        return read;
    }

    private Topic topicOf(ConsumerRecord<String, byte[]> record) {
        for (Topic topic : Topic.values()) {
            if (topic.of(fleet).equals(record.topic())) {
                return topic;
            }
        }
        throw new AssertionError(record.topic());
    }

    @Override
    public void close() {
        producer.close(Duration.ofSeconds(5));
        consumer.close();
    }
}
