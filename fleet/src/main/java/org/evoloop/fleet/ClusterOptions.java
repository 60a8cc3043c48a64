package org.evoloop.fleet;

import io.micrometer.core.instrument.binder.MeterBinder;
import java.io.IOException;
import java.io.PrintWriter;
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
import java.util.function.Supplier;
import org.apache.kafka.clients.consumer.ConsumerConfig;
import org.apache.kafka.clients.consumer.ConsumerRecord;
import org.apache.kafka.clients.consumer.KafkaConsumer;
import org.apache.kafka.clients.producer.KafkaProducer;
import org.apache.kafka.clients.producer.ProducerRecord;
import org.apache.kafka.common.KafkaException;
import org.apache.kafka.common.TopicPartition;
import org.evoloop.fleet.device.Model;
import org.evoloop.fleet.observe.Health;
import org.evoloop.fleet.observe.ObservationServer;
import org.evoloop.fleet.stream.FleetException;
import org.evoloop.fleet.stream.FleetTopics;
import org.evoloop.fleet.stream.KafkaCluster;
import org.evoloop.fleet.wire.ModelRecord;
import org.evoloop.fleet.wire.Topic;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.Option;

/** The options that name the fleet of a command, and writing to that fleet. */
final class ClusterOptions {
    /** What the option of that name does. */
    static final String KAFKA_CONFIG = "A file of properties with what Kafka's clients need to connect, such as"
            + " security.protocol for TLS and SASL (default: none is needed).";

    /** What the option {@code --metrics} does. */
    static final String METRICS =
            "Serves /metrics for Prometheus and /health, which answers 200 or 503, over HTTP; only on"
                    + " this machine unless HOST is given (default: nothing listens).";

    private static final Duration POLL = Duration.ofMillis(200);

    @Option(
            names = "--bootstrap",
            required = true,
            paramLabel = "HOST:PORT",
            description = "A broker of the Kafka cluster.")
    @SuppressWarnings("NullAway.Init") // picocli sets it
    private String bootstrap;

    @Option(names = "--kafka-config", paramLabel = "FILE", description = KAFKA_CONFIG)
    private @Nullable Path kafkaConfig;

    @Option(
            names = "--name",
            paramLabel = "NAME",
            defaultValue = "evoloop",
            description = "The fleet's name (default: evoloop).")
    @SuppressWarnings("NullAway.Init") // picocli sets it
    private String fleet;

    /**
     * The cluster.
     *
     * @throws FleetException if the file of settings cannot be used
     */
    KafkaCluster cluster() {
        return cluster(bootstrap, kafkaConfig);
    }

    static KafkaCluster cluster(String bootstrap, @Nullable Path kafkaConfig) {
        return kafkaConfig == null ? KafkaCluster.at(bootstrap) : KafkaCluster.at(bootstrap, kafkaConfig);
    }

    /** The fleet's name. */
    String fleet() {
        return fleet;
    }

    /** The server for {@code --metrics}; null if that was not given. */
    static @Nullable ObservationServer observed(
            @Nullable String address, MeterBinder metrics, Supplier<Health> health) {
        return address == null ? null : ObservationServer.open(address, metrics, health);
    }

    static void announce(@Nullable ObservationServer server, PrintWriter log) {
        if (server != null) {
            log.println("evoloop: metrics and health are at " + server.url() + "/metrics and /health");
        }
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
        try (FleetTopics topics = new FleetTopics(cluster(), fleet)) {
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
        try (KafkaConsumer<String, byte[]> consumer =
                cluster().consumer(Map.of(ConsumerConfig.ISOLATION_LEVEL_CONFIG, "read_committed"))) {
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
        try (KafkaProducer<String, byte[]> producer = cluster().producer(Map.of())) {
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
