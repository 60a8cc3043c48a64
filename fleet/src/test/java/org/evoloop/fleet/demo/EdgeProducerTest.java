package org.evoloop.fleet.demo;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.stream.IntStream;
import org.apache.kafka.clients.admin.Admin;
import org.apache.kafka.clients.admin.NewTopic;
import org.apache.kafka.clients.consumer.KafkaConsumer;
import org.apache.kafka.clients.producer.KafkaProducer;
import org.apache.kafka.clients.producer.ProducerConfig;
import org.apache.kafka.clients.producer.ProducerRecord;
import org.apache.kafka.common.TopicPartition;
import org.apache.kafka.common.serialization.IntegerDeserializer;
import org.apache.kafka.common.serialization.IntegerSerializer;
import org.apache.kafka.common.serialization.StringDeserializer;
import org.apache.kafka.common.serialization.StringSerializer;
import org.awaitility.Awaitility;
import org.evoloop.JavaProcess;
import org.evoloop.fleet.BrokerProcess;
import org.evoloop.fleet.TestProcess;
import org.evoloop.fleet.broker.LocalBroker;
import org.evoloop.fleet.stream.KafkaCluster;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;

/** A broker is killed after it has written records, before the demo's producer has read all answers. */
@Tag("slow")
@EnabledOnOs(OS.LINUX)
class EdgeProducerTest {
    private static final TopicPartition PLACE = new TopicPartition("presses", 0);
    private static final Duration LIMIT = Duration.ofMinutes(2);
    private static final int RECORDS = 20;

    /** So long that each record is a batch by itself. */
    private static final String TEXT = "x".repeat(10_000);

    @TempDir
    private Path directory;

    @Test
    void aRecordIsWrittenOnce() throws Exception {
        int port = LocalBroker.freePort();
        int controller = LocalBroker.freePort();
        String bootstrap = "localhost:" + port;
        Map<String, Object> settings = KafkaCluster.at(bootstrap).with(Edge.PRODUCER);
        int mostOnTheWay = (int) settings.getOrDefault(ProducerConfig.MAX_IN_FLIGHT_REQUESTS_PER_CONNECTION, 5);
        Process broker = BrokerProcess.start(directory, port, controller);
        CountDownLatch killed = new CountDownLatch(1);
        try (KafkaProducer<Integer, String> producer =
                new KafkaProducer<>(settings, new IntegerSerializer(), new StringSerializer())) {
            createTopic(bootstrap);
            producer.send(record(0)).get(LIMIT.toSeconds(), TimeUnit.SECONDS);

            JavaProcess.signal("STOP", broker);
            // The thread that calls back also reads the answers.
            producer.send(record(1), (at, failure) -> await(killed));
            for (int each = 2; each < RECORDS; each++) {
                producer.send(record(each));
            }
            Awaitility.await().atMost(LIMIT).until(() -> onTheWay(producer) == mostOnTheWay);
            JavaProcess.signal("CONT", broker);
            Awaitility.await().atMost(LIMIT).until(() -> written(bootstrap).size() > mostOnTheWay);
            TestProcess.kill(broker);
            killed.countDown();

            broker = BrokerProcess.start(directory, port, controller);
            producer.flush();
            assertThat(written(bootstrap))
                    .isEqualTo(IntStream.range(0, RECORDS).boxed().toList());
        } finally {
            killed.countDown();
            TestProcess.kill(broker);
        }
    }

    private static ProducerRecord<Integer, String> record(int number) {
        return new ProducerRecord<>(PLACE.topic(), number, TEXT);
    }

    private static double onTheWay(KafkaProducer<?, ?> producer) {
        return producer.metrics().entrySet().stream()
                .filter(each -> each.getKey().name().equals("requests-in-flight"))
                .mapToDouble(each -> (double) each.getValue().metricValue())
                .findFirst()
                .orElseThrow();
    }

    private static void createTopic(String bootstrap) throws Exception {
        try (Admin admin = Admin.create(Map.of("bootstrap.servers", bootstrap))) {
            admin.createTopics(List.of(new NewTopic(PLACE.topic(), 1, (short) 1)))
                    .all()
                    .get(LIMIT.toSeconds(), TimeUnit.SECONDS);
        }
    }

    /** The numbers of all records of the topic. */
    private static List<Integer> written(String bootstrap) {
        List<Integer> numbers = new ArrayList<>();
        try (KafkaConsumer<Integer, String> consumer = new KafkaConsumer<>(
                Map.of("bootstrap.servers", bootstrap), new IntegerDeserializer(), new StringDeserializer())) {
            consumer.assign(List.of(PLACE));
            consumer.seekToBeginning(List.of(PLACE));
            long end = consumer.endOffsets(List.of(PLACE)).get(PLACE);
            while (consumer.position(PLACE) < end) {
                consumer.poll(Duration.ofMillis(100)).forEach(each -> numbers.add(each.key()));
            }
        }
        return numbers;
    }

    private static void await(CountDownLatch latch) {
        try {
            latch.await();
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }
}
