package org.evoloop.fleet.bench;

import com.sun.management.OperatingSystemMXBean;
import java.lang.management.ManagementFactory;
import java.nio.file.Path;
import java.time.Duration;
import java.util.Comparator;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import java.util.concurrent.locks.LockSupport;
import org.apache.kafka.clients.admin.Admin;
import org.apache.kafka.clients.admin.OffsetSpec;
import org.apache.kafka.clients.consumer.OffsetAndMetadata;
import org.apache.kafka.common.TopicPartition;
import org.apache.kafka.streams.StoreQueryParameters;
import org.apache.kafka.streams.Topology;
import org.apache.kafka.streams.state.KeyValueIterator;
import org.apache.kafka.streams.state.QueryableStoreTypes;
import org.evoloop.fleet.stream.Fleet;
import org.evoloop.fleet.stream.FleetException;
import org.evoloop.fleet.stream.FleetSettings;
import org.evoloop.fleet.stream.FleetTopics;
import org.evoloop.fleet.stream.FleetTopology;
import org.evoloop.fleet.stream.KafkaCluster;
import org.evoloop.fleet.wire.ModelRecord;
import org.evoloop.fleet.wire.Topic;
import org.jspecify.annotations.Nullable;

/**
 * Measures how fast a backlog of records at the broker is processed, from when the instance runs until the last record
 * is committed.
 */
final class Throughput {
    private static final int PARTITIONS = 4;
    private static final Duration LIMIT = Duration.ofMinutes(10);
    private static final long LOOK_NANOS = 20_000_000;
    private static final OperatingSystemMXBean SYSTEM =
            (OperatingSystemMXBean) ManagementFactory.getOperatingSystemMXBean();

    private final KafkaCluster cluster;
    private final Path directory;
    private final ModelRecord lamp;
    private int runs;

    /**
     * The measurements of a run.
     *
     * @param seconds wall-clock time
     * @param cpuSeconds CPU time of this process, including the broker and Streams
     * @param bytesPerDevice the bytes stored for a device, key and value
     */
    record Measured(int events, double seconds, double cpuSeconds, double bytesPerDevice, double restoreSeconds) {
        double perSecond() {
            return events / seconds;
        }

        double perCpuSecond() {
            return events / cpuSeconds;
        }
    }

    Throughput(KafkaCluster cluster, Path directory, ModelRecord lamp) {
        this.cluster = cluster;
        this.directory = directory;
        this.lamp = lamp;
    }

    /** @param bare whether the records only pass through */
    Measured of(int devices, int events, boolean bare, boolean inMemory) throws InterruptedException {
        runs++;
        Exchange exchange = bare ? Exchange.with(lamp, Math.max(1, events / devices / Traffic.CYCLE)) : null;
        String name = "bench-" + runs;
        FleetSettings plain = FleetSettings.defaults()
                .withFleet(name)
                .withStateDirectory(directory.resolve(name))
                .withStreamTime();
        FleetSettings settings = inMemory ? plain.withDevicesInMemory() : plain;
        try (FleetTopics topics = new FleetTopics(cluster, name);
                Traffic traffic = new Traffic(cluster, name, devices);
                Admin admin = cluster.admin(Map.of())) {
            topics.create(PARTITIONS);
            traffic.write(Topic.MODELS, "lamp", lamp.bytes(), System.currentTimeMillis());
            traffic.register("lamp");
            try (Fleet fleet = started(settings, topology(settings, exchange))) {
                awaitDone(admin, fleet.name(), Topic.DEVICES);
            }
            traffic.happen(events);
            Measured measured = measure(admin, settings, topology(settings, exchange), events);
            topics.delete();
            return measured;
        }
    }

    private static Topology topology(FleetSettings settings, @Nullable Exchange exchange) {
        return exchange != null ? PassThrough.topology(settings, exchange) : FleetTopology.of(settings);
    }

    private Fleet started(FleetSettings settings, Topology topology) throws InterruptedException {
        Fleet fleet = new Fleet(cluster, settings, topology);
        fleet.start();
        if (!fleet.awaitRunning(LIMIT)) {
            fleet.close();
            throw new FleetException("the fleet did not start");
        }
        return fleet;
    }

    private Measured measure(Admin admin, FleetSettings settings, Topology topology, int events)
            throws InterruptedException {
        long starting = System.nanoTime();
        try (Fleet fleet = started(settings, topology)) {
            long begun = System.nanoTime();
            long cpu = SYSTEM.getProcessCpuTime();
            awaitDone(admin, settings.fleet(), Topic.OCCURRENCES);
            awaitDone(admin, settings.fleet(), Topic.EFFECTS);
            double seconds = (System.nanoTime() - begun) / 1e9;
            double cpuSeconds = (SYSTEM.getProcessCpuTime() - cpu) / 1e9;
            return new Measured(events, seconds, cpuSeconds, bytesPerDevice(fleet), (begun - starting) / 1e9);
        }
    }

    private static double bytesPerDevice(Fleet fleet) {
        long bytes = 0;
        long devices = 0;
        try (KeyValueIterator<String, byte[]> each = fleet.streams()
                .store(StoreQueryParameters.fromNameAndType(
                        "devices", QueryableStoreTypes.<String, byte[]>keyValueStore()))
                .all()) {
            while (each.hasNext()) {
                var next = each.next();
                bytes += next.key.length() + next.value.length;
                devices++;
            }
        }
        return devices == 0 ? 0 : (double) bytes / devices;
    }

    private static void awaitDone(Admin admin, String fleet, Topic topic) throws InterruptedException {
        Map<TopicPartition, OffsetSpec> wanted = new HashMap<>();
        for (int each = 0; each < PARTITIONS; each++) {
            wanted.put(new TopicPartition(topic.of(fleet), each), OffsetSpec.latest());
        }
        long begun = System.nanoTime();
        try {
            var ends = admin.listOffsets(wanted).all().get(1, TimeUnit.MINUTES);
            while (true) {
                Map<TopicPartition, OffsetAndMetadata> done = admin.listConsumerGroupOffsets(fleet)
                        .partitionsToOffsetAndMetadata()
                        .get(1, TimeUnit.MINUTES);
                boolean all = ends.entrySet().stream().allMatch(end -> {
                    OffsetAndMetadata at = done.get(end.getKey());
                    return end.getValue().offset() == 0
                            || (at != null && at.offset() >= end.getValue().offset());
                });
                if (all) {
                    return;
                } else if (System.nanoTime() - begun > LIMIT.toNanos()) {
                    throw new FleetException("the records were not processed within " + LIMIT);
                }
                LockSupport.parkNanos(LOOK_NANOS);
            }
        } catch (ExecutionException | TimeoutException e) {
            throw new FleetException("the broker does not answer: " + e.getMessage());
        }
    }

    /** The median of several runs by CPU time. */
    static Measured median(List<Measured> runs) {
        return runs.stream()
                .sorted(Comparator.comparingDouble(Measured::cpuSeconds))
                .toList()
                .get(runs.size() / 2);
    }
}
