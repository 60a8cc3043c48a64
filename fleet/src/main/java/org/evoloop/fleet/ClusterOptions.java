package org.evoloop.fleet;

import java.util.Map;
import java.util.concurrent.ExecutionException;
import org.apache.kafka.clients.producer.KafkaProducer;
import org.apache.kafka.clients.producer.ProducerConfig;
import org.apache.kafka.clients.producer.ProducerRecord;
import org.apache.kafka.common.serialization.ByteArraySerializer;
import org.apache.kafka.common.serialization.StringSerializer;
import org.evoloop.fleet.stream.FleetException;
import org.evoloop.fleet.stream.FleetTopics;
import org.evoloop.fleet.wire.Topic;
import picocli.CommandLine.Option;

/** Which fleet a command is for, and how it writes to that. */
final class ClusterOptions {
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

    /** Where a broker is, as HOST:PORT. */
    String bootstrap() {
        return bootstrap;
    }

    /** The fleet's name. */
    String fleet() {
        return fleet;
    }

    /** @throws FleetException if the fleet's topics are not as they have to be */
    void check() {
        try (FleetTopics topics = new FleetTopics(bootstrap, fleet)) {
            topics.check();
        }
    }

    /** Writes these records, all of them before it returns. */
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
