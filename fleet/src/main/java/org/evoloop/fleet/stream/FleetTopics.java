package org.evoloop.fleet.stream;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Objects;
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
import org.apache.kafka.clients.admin.Config;
import org.apache.kafka.clients.admin.ConfigEntry;
import org.apache.kafka.clients.admin.NewTopic;
import org.apache.kafka.clients.admin.TopicDescription;
import org.apache.kafka.common.KafkaFuture;
import org.apache.kafka.common.config.ConfigResource;
import org.apache.kafka.common.errors.ApiException;
import org.apache.kafka.common.errors.AuthenticationException;
import org.apache.kafka.common.errors.AuthorizationException;
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

    private final KafkaCluster cluster;
    private final String fleet;
    private final Admin admin;

    /** @throws FleetException if the cluster's address or a setting is wrong */
    public FleetTopics(KafkaCluster cluster, String fleet) {
        this.cluster = cluster;
        this.fleet = fleet;
        this.admin = cluster.admin(Map.of(
                AdminClientConfig.DEFAULT_API_TIMEOUT_MS_CONFIG, 10_000,
                AdminClientConfig.REQUEST_TIMEOUT_MS_CONFIG, 5_000));
    }

    /** Creates the missing topics as the cluster does by default. */
    public void create(int partitions) {
        create(partitions, TopicSettings.DEFAULTS);
    }

    /**
     * Creates the missing topics; those that exist remain as they are, which {@link #check} verifies.
     *
     * @param partitions the number of partitions of the devices
     * @throws FleetException if the cluster refuses the settings, such as more replicas than it has brokers
     */
    public void create(int partitions, TopicSettings settings) {
        for (Topic topic : Topic.values()) {
            NewTopic wanted = new NewTopic(
                    topic.of(fleet),
                    Optional.of(topic.isByDevice() ? partitions : 1),
                    settings.replicas() == 0 ? Optional.empty() : Optional.of((short) settings.replicas()));
            wanted.configs(settings.of(topic.isCompacted()));
            try {
                await(admin.createTopics(List.of(wanted)).all());
            } catch (TopicExistsException asItIs) {
                // check() and differences() verify that it fits.
            } catch (ApiException refused) {
                throw new FleetException(
                        "the cluster does not create the topic " + topic.of(fleet) + ": " + refused.getMessage());
            }
        }
        awaitKnown();
    }

    /** How the existing topics differ from {@code settings}, for people; {@link #create} does not change these. */
    public List<String> differences(TopicSettings settings) {
        List<String> differences = new ArrayList<>();
        for (Topic topic : Topic.values()) {
            String name = topic.of(fleet);
            int replicas = Objects.requireNonNull(
                            await(admin.describeTopics(List.of(name)).allTopicNames())
                                    .get(name))
                    .partitions()
                    .get(0)
                    .replicas()
                    .size();
            if (settings.replicas() != 0 && settings.replicas() != replicas) {
                differences.add(name + " has " + replicas + " replicas, not " + settings.replicas());
            }
            ConfigResource resource = new ConfigResource(ConfigResource.Type.TOPIC, name);
            Config config =
                    await(admin.describeConfigs(List.of(resource)).all()).get(resource);
            settings.values().forEach((key, wanted) -> {
                ConfigEntry found = config == null ? null : config.get(key);
                if (found == null || !wanted.equals(found.value())) {
                    differences.add(
                            name + " has " + key + "=" + (found == null ? "" : found.value()) + ", not " + wanted);
                }
            });
        }
        return differences;
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
            throw new FleetException(
                    "the topics of the fleet '" + fleet + "' at " + cluster.bootstrap() + " cannot be used:\n"
                            + String.join("\n", problems)
                            + "\nCreate what is missing with: evoloop fleet --bootstrap " + cluster.bootstrap()
                            + " --name " + fleet
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
            if (e.getCause() instanceof AuthenticationException || e.getCause() instanceof AuthorizationException) {
                throw refused((ApiException) e.getCause());
            } else if (e.getCause() instanceof ApiException answer
                    && !(answer instanceof org.apache.kafka.common.errors.TimeoutException)) {
                throw answer;
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
        return new UnreachableException("the Kafka broker at " + cluster.bootstrap() + " does not answer properly: "
                + cause.getMessage() + ". " + cluster.hint());
    }

    private FleetException refused(ApiException refusal) {
        Throwable cause = refusal.getCause();
        return new FleetException(
                "the Kafka broker at " + cluster.bootstrap() + " refuses this program: " + refusal.getMessage()
                        + (cause == null ? "" : " (" + cause.getMessage() + ")") + ". " + cluster.hint());
    }

    @Override
    public void close() {
        admin.close();
    }
}
