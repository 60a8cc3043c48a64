package org.evoloop.fleet.stream;

import io.micrometer.core.instrument.binder.MeterBinder;
import io.micrometer.core.instrument.binder.kafka.KafkaStreamsMetrics;
import java.time.Duration;
import java.util.Locale;
import java.util.Map;
import java.util.Properties;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import org.apache.kafka.clients.consumer.ConsumerConfig;
import org.apache.kafka.clients.producer.ProducerConfig;
import org.apache.kafka.common.KafkaException;
import org.apache.kafka.common.errors.AuthenticationException;
import org.apache.kafka.common.errors.AuthorizationException;
import org.apache.kafka.common.errors.InvalidSessionTimeoutException;
import org.apache.kafka.streams.CloseOptions;
import org.apache.kafka.streams.KafkaStreams;
import org.apache.kafka.streams.StreamsConfig;
import org.apache.kafka.streams.Topology;
import org.apache.kafka.streams.errors.MissingSourceTopicException;
import org.apache.kafka.streams.errors.StreamsUncaughtExceptionHandler.StreamThreadExceptionResponse;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * One instance of a fleet: any number of them, on any machines, share the devices.
 *
 * <p>Threading: thread-safe.
 *
 * @since 0.1
 */
public final class Fleet implements AutoCloseable {
    private static final Logger LOG = LoggerFactory.getLogger(Fleet.class);

    private static final long REPLAY_IDLE_MILLIS = 1_000;
    private static final int BATCH_BYTES = 128 << 10;
    private static final long MOST_LINGER_MILLIS = 1_000;
    private static final Duration CLOSING = Duration.ofSeconds(30);

    private final String name;
    private final Duration session;
    private final KafkaStreams streams;
    private final FleetCounts counts;
    private final KafkaStreamsMetrics kafkaMetrics;
    private final CountDownLatch running = new CountDownLatch(1);
    private final CountDownLatch ended = new CountDownLatch(1);
    private volatile @Nullable Throwable failure;

    /**
     * An instance that is not started yet.
     *
     * @throws FleetException if Kafka refuses the settings, or the state directory cannot be used
     */
    public Fleet(KafkaCluster cluster, FleetSettings settings) {
        this(cluster, settings, new FleetCounts());
    }

    private Fleet(KafkaCluster cluster, FleetSettings settings, FleetCounts counts) {
        this(cluster, settings, FleetTopology.of(settings, counts), counts);
    }

    /** An instance with another topology, for example for comparison. */
    public Fleet(KafkaCluster cluster, FleetSettings settings, Topology topology) {
        this(cluster, settings, topology, new FleetCounts());
    }

    private Fleet(KafkaCluster cluster, FleetSettings settings, Topology topology, FleetCounts counts) {
        this.counts = counts;
        name = settings.fleet();
        session = settings.session();
        streams = streams(topology, cluster, settings);
        kafkaMetrics = new KafkaStreamsMetrics(streams);
        streams.setStateListener((now, before) -> {
            if (now == KafkaStreams.State.RUNNING) {
                running.countDown();
            } else if (now == KafkaStreams.State.ERROR || now == KafkaStreams.State.NOT_RUNNING) {
                running.countDown();
                ended.countDown();
            }
        });
        streams.setUncaughtExceptionHandler(cause -> {
            if (isHopeless(cause) || isHopeless(cause.getCause())) {
                failure = cause;
                return StreamThreadExceptionResponse.SHUTDOWN_CLIENT;
            }
            LOG.error("a thread of the fleet has failed", cause);
            return StreamThreadExceptionResponse.REPLACE_THREAD;
        });
    }

    private static KafkaStreams streams(Topology topology, KafkaCluster cluster, FleetSettings settings) {
        try {
            return new KafkaStreams(topology, properties(cluster, settings));
        } catch (KafkaException e) {
            throw new FleetException("the instance cannot start with the state directory " + settings.stateDirectory()
                    + ": " + root(e).getMessage()
                    + "; each instance on a computer needs its own, given with --state-dir");
        }
    }

    private static Throwable root(Throwable failure) {
        Throwable cause = failure;
        while (cause.getCause() != null) {
            cause = cause.getCause();
        }
        return cause;
    }

    /** Whether a new thread would fail in the same way. */
    private static boolean isHopeless(@Nullable Throwable cause) {
        return cause instanceof MissingSourceTopicException
                || cause instanceof InvalidSessionTimeoutException
                || cause instanceof AuthenticationException
                || cause instanceof AuthorizationException;
    }

    private static Properties properties(KafkaCluster cluster, FleetSettings settings) {
        Properties properties = new Properties();
        properties.putAll(cluster.with(Map.of(StreamsConfig.APPLICATION_ID_CONFIG, settings.fleet())));
        properties.put(StreamsConfig.STATE_DIR_CONFIG, settings.stateDirectory().toString());
        properties.put(StreamsConfig.PROCESSING_GUARANTEE_CONFIG, StreamsConfig.EXACTLY_ONCE_V2);
        properties.put(
                StreamsConfig.COMMIT_INTERVAL_MS_CONFIG,
                settings.commitInterval().toMillis());
        properties.put(StreamsConfig.NUM_STREAM_THREADS_CONFIG, settings.threads());
        properties.put(StreamsConfig.NUM_STANDBY_REPLICAS_CONFIG, settings.standbys());
        TopicSettings topics = settings.topics();
        if (topics.replicas() > 0) {
            properties.put(StreamsConfig.REPLICATION_FACTOR_CONFIG, topics.replicas());
        }
        topics.values().forEach((name, value) -> properties.put(StreamsConfig.topicPrefix(name), value));
        properties.put(StreamsConfig.STATESTORE_CACHE_MAX_BYTES_CONFIG, 64L << 20);
        // A replay processes records in the order of their times. Live records need not wait for each other: an answer
        // comes after its command, and the core copes with an unknown order of occurrences and answers.
        properties.put(StreamsConfig.MAX_TASK_IDLE_MS_CONFIG, settings.isWallClock() ? 0L : REPLAY_IDLE_MILLIS);
        properties.put(StreamsConfig.consumerPrefix(ConsumerConfig.SESSION_TIMEOUT_MS_CONFIG), (int)
                settings.session().toMillis());
        properties.put(StreamsConfig.consumerPrefix(ConsumerConfig.HEARTBEAT_INTERVAL_MS_CONFIG), (int)
                Math.min(3_000, settings.session().toMillis() / 3));
        // A record is invisible until it is committed, so it can be batched until then.
        properties.put(StreamsConfig.producerPrefix(ProducerConfig.LINGER_MS_CONFIG), (int)
                Math.min(settings.commitInterval().toMillis(), MOST_LINGER_MILLIS));
        properties.put(StreamsConfig.producerPrefix(ProducerConfig.BATCH_SIZE_CONFIG), BATCH_BYTES);
        // At the start of a transaction the broker may reject the first of several requests, and then all others.
        properties.put(StreamsConfig.producerPrefix(ProducerConfig.MAX_IN_FLIGHT_REQUESTS_PER_CONNECTION), 1);
        return properties;
    }

    /** Starts it; {@link #awaitRunning} waits until it runs. */
    public void start() {
        streams.start();
    }

    /** Waits until it has its share of the devices; false if it has not within {@code limit}, or has failed. */
    public boolean awaitRunning(Duration limit) throws InterruptedException {
        return running.await(limit.toMillis(), TimeUnit.MILLISECONDS)
                && streams.state() != KafkaStreams.State.ERROR
                && streams.state() != KafkaStreams.State.NOT_RUNNING;
    }

    /**
     * Waits until it has ended.
     *
     * @throws FleetException if it has failed
     */
    public void awaitEnd() throws InterruptedException {
        ended.await();
        Throwable cause = failure;
        if (cause != null) {
            throw new FleetException("the fleet has ended: " + root(cause).getMessage());
        }
    }

    /** Whether it processes records, or will once it has its share of the devices. */
    public boolean isRunning() {
        return streams.state().isRunningOrRebalancing();
    }

    /** Whether it has told the cluster lately that it lives; the others take the devices of an instance that does not. */
    public boolean reachesKafka() {
        return streams.metrics().values().stream()
                .filter(each -> each.metricName().name().equals("last-heartbeat-seconds-ago"))
                .anyMatch(each -> each.metricValue() instanceof Double seconds
                        && seconds >= 0
                        && seconds * 1_000 <= session.toMillis());
    }

    /** Its status, for people. */
    public String describe() {
        String state = "the instance is "
                + streams.state().name().toLowerCase(Locale.ROOT).replace('_', ' ');
        return reachesKafka() ? state : state + "; no broker of Kafka is reached";
    }

    /**
     * Its metrics: {@code evoloop.fleet.results} and {@code evoloop.fleet.dead.letters} since its start, and those of Kafka
     * Streams.
     */
    public MeterBinder metrics() {
        return registry -> {
            counts.bindTo(registry);
            kafkaMetrics.bindTo(registry);
        };
    }

    /** The prefix of its topics. */
    public String name() {
        return name;
    }

    /** The Kafka Streams instance, for inspection. */
    public KafkaStreams streams() {
        return streams;
    }

    @Override
    public void close() {
        // Leaving the group lets the other instances take over at once instead of waiting for the session timeout.
        streams.close(CloseOptions.timeout(CLOSING)
                .withGroupMembershipOperation(CloseOptions.GroupMembershipOperation.LEAVE_GROUP));
        kafkaMetrics.close();
        ended.countDown();
    }
}
