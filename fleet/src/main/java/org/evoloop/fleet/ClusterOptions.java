package org.evoloop.fleet;

import java.io.IOException;
import java.nio.charset.MalformedInputException;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.TreeMap;
import java.util.concurrent.ExecutionException;
import org.apache.kafka.clients.consumer.ConsumerConfig;
import org.apache.kafka.clients.consumer.ConsumerRecord;
import org.apache.kafka.clients.consumer.KafkaConsumer;
import org.apache.kafka.clients.producer.KafkaProducer;
import org.apache.kafka.clients.producer.ProducerConfig;
import org.apache.kafka.clients.producer.ProducerRecord;
import org.apache.kafka.common.KafkaException;
import org.apache.kafka.common.TopicPartition;
import org.apache.kafka.common.serialization.ByteArrayDeserializer;
import org.apache.kafka.common.serialization.ByteArraySerializer;
import org.apache.kafka.common.serialization.StringDeserializer;
import org.apache.kafka.common.serialization.StringSerializer;
import org.evoloop.fleet.device.Model;
import org.evoloop.fleet.stream.FleetException;
import org.evoloop.fleet.stream.FleetTopics;
import org.evoloop.fleet.wire.ModelRecord;
import org.evoloop.fleet.wire.Topic;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.Option;

/** The options that name the fleet of a command, and writing to that fleet. */
final class ClusterOptions {
    private static final Duration POLL = Duration.ofMillis(200);

    @Option(
            names = "--bootstrap",
            required = true,
            paramLabel = "HOST:PORT",
            description = "A broker of the Kafka cluster.")
    @SuppressWarnings("NullAway.Init") // picocli sets it
    private String bootstrap;

    @Option(
            names = "--name",
            paramLabel = "NAME",
            defaultValue = "evoloop",
            description = "The fleet's name (default: evoloop).")
    @SuppressWarnings("NullAway.Init") // picocli sets it
    private String fleet;

    /** The address of a broker, as HOST:PORT. */
    String bootstrap() {
        return bootstrap;
    }

    /** The fleet's name. */
    String fleet() {
        return fleet;
    }

    /** @throws FleetException if there is no such file, or it is not text */
    static String text(Path file) {
        try {
            return Files.readString(file);
        } catch (NoSuchFileException e) {
            throw new FleetException("there is no file " + file);
        } catch (MalformedInputException e) {
            throw new FleetException(file + " is not text in UTF-8");
        } catch (IOException e) {
            throw new FleetException(file + " cannot be read: " + e.getMessage());
        }
    }

    /** @throws FleetException if topics of the fleet are missing or do not fit */
    void check() {
        try (FleetTopics topics = new FleetTopics(bootstrap, fleet)) {
            topics.check();
        }
    }

    /**
     * The models published as {@code version}.
     *
     * @throws FleetException if there are none
     */
    Model requireModels(String version) {
        byte[] record = models(version);
        if (record == null) {
            throw new FleetException(
                    "there are no models " + version + " in the fleet '" + fleet + "'; publish them first");
        }
        return ModelRecord.read(version, record);
    }

    /** @throws FleetException if {@code text} is empty: a topic takes no record without a key */
    static void requireName(String what, String text) {
        if (text.isBlank()) {
            throw new FleetException(what + " is empty");
        }
    }

    /** The record of the models published as {@code version}; null if there are none. */
    byte @Nullable [] models(String version) {
        return last(Topic.MODELS).get(version);
    }

    /** The last record of each key in this topic, which has one partition; without the keys deleted since. */
    Map<String, byte[]> last(Topic topic) {
        check();
        TopicPartition all = new TopicPartition(topic.of(fleet), 0);
        Map<String, byte[]> last = new TreeMap<>();
        try (KafkaConsumer<String, byte[]> consumer = new KafkaConsumer<>(
                Map.of(
                        ConsumerConfig.BOOTSTRAP_SERVERS_CONFIG,
                        bootstrap,
                        ConsumerConfig.ISOLATION_LEVEL_CONFIG,
                        "read_committed"),
                new StringDeserializer(),
                new ByteArrayDeserializer())) {
            consumer.assign(List.of(all));
            consumer.seekToBeginning(List.of(all));
            long end = consumer.endOffsets(List.of(all)).getOrDefault(all, 0L);
            while (consumer.position(all) < end) {
                for (ConsumerRecord<String, byte[]> record : consumer.poll(POLL)) {
                    // Only a topic that was created without compaction can have a record without a key.
                    String key = Objects.requireNonNullElse(record.key(), "");
                    if (record.value() == null) {
                        last.remove(key);
                    } else {
                        last.put(key, record.value());
                    }
                }
            }
        } catch (KafkaException e) {
            throw new FleetException("the broker at " + bootstrap + " does not return the records of " + topic.of(fleet)
                    + ": " + e.getMessage());
        }
        return last;
    }

    /** Writes these records, and waits until all are written. */
    void write(Topic topic, Map<String, byte[]> records) throws InterruptedException {
        check();
        try (KafkaProducer<String, byte[]> producer = new KafkaProducer<>(
                Map.of(ProducerConfig.BOOTSTRAP_SERVERS_CONFIG, bootstrap),
                new StringSerializer(),
                new ByteArraySerializer())) {
            for (Map.Entry<String, byte[]> record : records.entrySet()) {
                producer.send(new ProducerRecord<>(topic.of(fleet), record.getKey(), record.getValue()))
                        .get();
            }
        } catch (ExecutionException e) {
            throw new FleetException("the broker at " + bootstrap + " did not take the record: "
                    + (e.getCause() == null ? e : e.getCause()).getMessage());
        }
    }
}
