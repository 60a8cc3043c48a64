package org.evoloop.fleet.broker;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.TimeUnit;
import java.util.stream.IntStream;
import org.apache.kafka.clients.admin.Admin;
import org.apache.kafka.clients.admin.NewTopic;
import org.apache.kafka.clients.producer.KafkaProducer;
import org.apache.kafka.clients.producer.ProducerConfig;
import org.apache.kafka.clients.producer.ProducerRecord;
import org.apache.kafka.common.TopicPartition;
import org.apache.kafka.common.serialization.IntegerSerializer;
import org.awaitility.Awaitility;
import org.evoloop.fleet.BrokerProcess;
import org.evoloop.fleet.TestProcess;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** A broker that is killed while transactions end. */
@Tag("slow")
class LocalBrokerTest {
    private static final String TOPIC = "records";
    private static final int PARTITIONS = 200;
    private static final int PRODUCERS = 6;
    private static final Duration LIMIT = Duration.ofMinutes(1);

    @TempDir
    private Path directory;

    @Test
    void everyTransactionEnds() throws Exception {
        int port = LocalBroker.freePort();
        int controller = LocalBroker.freePort();
        Process broker = BrokerProcess.start(directory, port, controller);
        List<KafkaProducer<Integer, Integer>> producers = new ArrayList<>();
        try (Admin admin = Admin.create(Map.of("bootstrap.servers", "localhost:" + port))) {
            admin.createTopics(List.of(new NewTopic(TOPIC, PARTITIONS, (short) 1)))
                    .all()
                    .get(LIMIT.toSeconds(), TimeUnit.SECONDS);
            for (int each = 0; each < PRODUCERS; each++) {
                producers.add(writing("localhost:" + port, "producer-" + each));
            }
            assertThat(open(admin)).isEqualTo(PRODUCERS * PARTITIONS);

            // A commit returns before the partitions have its end.
            CompletableFuture.anyOf(producers.stream()
                            .map(each -> CompletableFuture.runAsync(each::commitTransaction))
                            .toArray(CompletableFuture<?>[]::new))
                    .get(LIMIT.toSeconds(), TimeUnit.SECONDS);
            TestProcess.kill(broker);
            producers.forEach(each -> each.close(Duration.ZERO));

            broker = BrokerProcess.start(directory, port, controller);
            Awaitility.await().atMost(LIMIT).until(() -> open(admin) == 0);
        } finally {
            producers.forEach(each -> each.close(Duration.ZERO));
            TestProcess.kill(broker);
        }
    }

    /** A producer that has written a record to each partition, in a transaction that is still open. */
    private static KafkaProducer<Integer, Integer> writing(String bootstrap, String name) {
        KafkaProducer<Integer, Integer> producer = new KafkaProducer<>(
                Map.of(
                        ProducerConfig.BOOTSTRAP_SERVERS_CONFIG,
                        bootstrap,
                        ProducerConfig.TRANSACTIONAL_ID_CONFIG,
                        name,
                        ProducerConfig.TRANSACTION_TIMEOUT_CONFIG,
                        10_000),
                new IntegerSerializer(),
                new IntegerSerializer());
        producer.initTransactions();
        producer.beginTransaction();
        for (int each = 0; each < PARTITIONS; each++) {
            producer.send(new ProducerRecord<>(TOPIC, each, each, each));
        }
        producer.flush();
        return producer;
    }

    /** How many transactions are open in the partitions, counted once for each partition. */
    private static long open(Admin admin) throws Exception {
        return admin
                .describeProducers(IntStream.range(0, PARTITIONS)
                        .mapToObj(each -> new TopicPartition(TOPIC, each))
                        .toList())
                .all()
                .get(LIMIT.toSeconds(), TimeUnit.SECONDS)
                .values()
                .stream()
                .flatMap(each -> each.activeProducers().stream())
                .filter(each -> each.currentTransactionStartOffset().isPresent())
                .count();
    }
}
