package org.evoloop.fleet.stream;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.List;
import java.util.Map;
import org.apache.kafka.clients.admin.Admin;
import org.apache.kafka.clients.admin.NewTopic;
import org.evoloop.fleet.Brokers;
import org.junit.jupiter.api.Test;

/** Topics that are missing or do not fit together are all named in one message. */
class FleetTopicsTest {
    @Test
    void missingAndMismatchedTopicsAreNamed() throws Exception {
        String fleet = Brokers.freshFleet();
        try (FleetTopics topics = new FleetTopics(KafkaCluster.at(Brokers.shared()), fleet)) {
            assertThatThrownBy(topics::check)
                    .isInstanceOf(FleetException.class)
                    .hasMessageContaining(fleet + ".occurrences is missing")
                    .hasMessageContaining(fleet + ".models is missing")
                    .hasMessageContaining("--create-topics");
            try (Admin admin = Admin.create(Map.of("bootstrap.servers", Brokers.shared()))) {
                admin.createTopics(List.of(new NewTopic(fleet + ".effects", 3, (short) 1)))
                        .all()
                        .get();
            }
            topics.create(2);
            assertThatThrownBy(topics::check)
                    .isInstanceOf(FleetException.class)
                    .hasMessageContaining(fleet + ".effects has 3 partitions, " + fleet + ".occurrences has 2")
                    .hasMessageNotContaining(".states is missing");
            topics.delete();
            assertThatThrownBy(topics::check).hasMessageContaining(fleet + ".effects is missing");
        }
    }

    @Test
    void anInvalidAddressIsReported() {
        assertThatThrownBy(() -> new FleetTopics(KafkaCluster.at("nowhere"), "x"))
                .isInstanceOf(FleetException.class)
                .hasMessageContaining("'nowhere' is not the address of a Kafka broker");
        try (FleetTopics topics = new FleetTopics(KafkaCluster.at("localhost:1"), "x")) {
            assertThatThrownBy(topics::check)
                    .isInstanceOf(FleetException.class)
                    .hasMessageContaining("localhost:1")
                    .hasMessageContaining("Is it running");
        }
    }

    @Test
    void theySuit() throws Exception {
        try (FleetTopics topics = new FleetTopics(KafkaCluster.at(Brokers.shared()), Brokers.freshFleet())) {
            topics.create(3);
            topics.create(5);
            assertThat(topics.check()).isEqualTo(3);
            topics.delete();
        }
    }
}
