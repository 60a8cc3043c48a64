package org.evoloop.fleet.stream;

import java.util.Map;
import java.util.TreeMap;
import org.apache.kafka.common.config.TopicConfig;

/**
 * How a cluster keeps the topics that a fleet creates, including those in which its instances store their state.
 *
 * <p>Threading: immutable.
 *
 * @param replicas how many brokers keep each partition; 0 for as many as the cluster does by default
 * @param values Kafka's settings of a topic by name, such as {@code min.insync.replicas}
 * @since 0.1
 */
public record TopicSettings(int replicas, Map<String, String> values) {
    /** As the cluster does by default. */
    public static final TopicSettings DEFAULTS = new TopicSettings(0, Map.of());

    private static final int MOST_REPLICAS = 100;

    /** @throws IllegalArgumentException if a value is not allowed */
    public TopicSettings {
        if (replicas < 0 || replicas > MOST_REPLICAS) {
            throw new IllegalArgumentException(
                    "the number of replicas is " + replicas + ", allowed is 1 to " + MOST_REPLICAS);
        }
        if (values.containsKey(TopicConfig.CLEANUP_POLICY_CONFIG)) {
            throw new IllegalArgumentException(
                    TopicConfig.CLEANUP_POLICY_CONFIG + " differs from topic to topic, and the fleet sets it");
        }
        values = Map.copyOf(values);
    }

    /** The settings of a topic, of which only the last record of each key counts if it is {@code compacted}. */
    Map<String, String> of(boolean compacted) {
        Map<String, String> all = new TreeMap<>(values);
        if (compacted) {
            all.put(TopicConfig.CLEANUP_POLICY_CONFIG, TopicConfig.CLEANUP_POLICY_COMPACT);
        }
        return all;
    }
}
