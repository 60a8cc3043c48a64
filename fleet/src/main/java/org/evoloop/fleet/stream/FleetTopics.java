package org.evoloop.fleet.stream;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import java.util.concurrent.locks.LockSupport;
import java.util.stream.Stream;
import org.apache.kafka.clients.admin.Admin;
import org.apache.kafka.clients.admin.AdminClientConfig;
import org.apache.kafka.clients.admin.NewTopic;
import org.apache.kafka.clients.admin.TopicDescription;
import org.apache.kafka.common.KafkaException;
import org.apache.kafka.common.KafkaFuture;
import org.apache.kafka.common.config.TopicConfig;
import org.apache.kafka.common.errors.TopicExistsException;
import org.apache.kafka.common.errors.UnknownTopicOrPartitionException;
import org.evoloop.fleet.wire.Topic;

/**
 * The topics of a fleet in a cluster.
 *
 * <p>Threading: not thread-safe.
 *
 * @since 0.1
 */
public final class FleetTopics implements AutoCloseable {
    private static final long LIMIT_S = 30;
    private static final long LOOK_MILLIS = 50;

    private final String bootstrap;
    private final String fleet;
    private final Admin admin;

    /** @throws FleetException if {@code bootstrap} is not an address */
    public FleetTopics(String bootstrap, String fleet) {
        this.bootstrap = bootstrap;
        this.fleet = fleet;
        try {
            this.admin = Admin.create(Map.of(
                    AdminClientConfig.BOOTSTRAP_SERVERS_CONFIG, bootstrap,
                    AdminClientConfig.DEFAULT_API_TIMEOUT_MS_CONFIG, 10_000,
                    AdminClientConfig.REQUEST_TIMEOUT_MS_CONFIG, 5_000));
        } catch (KafkaException e) {
            String why = e.getCause() == null ? e.getMessage() : e.getCause().getMessage();
            throw new FleetException("'" + bootstrap + "' is not the address of a Kafka broker, HOST:PORT: " + why);
        }
    }

    /** Creates the missing topics; {@code partitions} is the number of partitions of the devices. */
    public void create(int partitions) {
        for (Topic topic : Topic.values()) {
            NewTopic wanted =
                    new NewTopic(topic.of(fleet), Optional.of(topic.isByDevice() ? partitions : 1), Optional.empty());
            if (topic.isCompacted()) {
                wanted.configs(Map.of(TopicConfig.CLEANUP_POLICY_CONFIG, TopicConfig.CLEANUP_POLICY_COMPACT));
            }
            try {
                await(admin.createTopics(List.of(wanted)).all());
            } catch (TopicExistsException asItIs) {
                // check() verifies that it fits.
            }
        }
        awaitKnown();
    }

    /** Waits until the brokers know the topics that the controller has created. */
    private void awaitKnown() {
        List<String> names =
                Stream.of(Topic.values()).map(topic -> topic.of(fleet)).toList();
        for (long waited = 0; waited < LIMIT_S * 1_000; waited += LOOK_MILLIS) {
            try {
                await(admin.describeTopics(names).allTopicNames());
                return;
            } catch (UnknownTopicOrPartitionException notYet) {
                LockSupport.parkNanos(TimeUnit.MILLISECONDS.toNanos(LOOK_MILLIS));
            }
        }
    }

    /**
     * Checks that all topics exist and fit together; returns the number of partitions of the devices.
     *
     * @throws UnreachableException if no broker answers
     * @throws FleetException naming all topics that are missing or do not fit
     */
    public int check() {
        Map<Topic, Integer> found = new TreeMap<>();
        List<String> problems = new ArrayList<>();
        for (Topic topic : Topic.values()) {
            try {
                TopicDescription description = await(
                                admin.describeTopics(List.of(topic.of(fleet))).allTopicNames())
                        .get(topic.of(fleet));
                found.put(
                        topic,
                        description == null ? 0 : description.partitions().size());
            } catch (UnknownTopicOrPartitionException missing) {
                problems.add("  " + topic.of(fleet) + " is missing");
            }
        }
        int partitions = found.getOrDefault(Topic.OCCURRENCES, 0);
        for (Map.Entry<Topic, Integer> each : found.entrySet()) {
            if (partitions > 0 && each.getKey().isByDevice() && each.getValue() != partitions) {
                problems.add("  " + each.getKey().of(fleet) + " has " + each.getValue() + " partitions, "
                        + Topic.OCCURRENCES.of(fleet) + " has " + partitions
                        + "; these numbers must be equal");
            }
        }
        if (!problems.isEmpty()) {
            throw new FleetException("the topics of the fleet '" + fleet + "' at " + bootstrap + " cannot be used:\n"
                    + String.join("\n", problems)
                    + "\nCreate what is missing with: evoloop fleet --bootstrap " + bootstrap + " --name " + fleet
                    + " --create-topics; delete first what has a wrong number of partitions");
        }
        return partitions;
    }

    /** Deletes the topics with their contents, and the instances' state in the cluster. */
    public void delete() {
        Set<String> all = new TreeSet<>(await(admin.listTopics().names()));
        all.removeIf(name -> !name.startsWith(fleet + '.') && !name.startsWith(fleet + '-'));
        await(admin.deleteTopics(all).all());
    }

    private <T> T await(KafkaFuture<T> future) {
        try {
            return future.get(LIMIT_S, TimeUnit.SECONDS);
        } catch (ExecutionException e) {
            if (e.getCause() instanceof TopicExistsException exists) {
                throw exists;
            } else if (e.getCause() instanceof UnknownTopicOrPartitionException missing) {
                throw missing;
            }
            throw unreachable(e);
        } catch (TimeoutException e) {
            throw unreachable(e);
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            throw new FleetException("interrupted while waiting for the broker");
        }
    }

    private UnreachableException unreachable(Exception failure) {
        Throwable cause = failure.getCause() == null ? failure : failure.getCause();
        return new UnreachableException("the Kafka broker at " + bootstrap + " does not answer properly: "
                + cause.getMessage() + ". Is it running, and is --bootstrap its address?");
    }

    @Override
    public void close() {
        admin.close();
    }
}
