package org.evoloop.fleet.demo;

import java.time.Duration;
import java.util.Set;
import java.util.function.BooleanSupplier;
import org.evoloop.fleet.device.Model;
import org.evoloop.fleet.stream.FleetException;
import org.evoloop.fleet.stream.FleetTopics;
import org.evoloop.fleet.stream.KafkaCluster;
import org.evoloop.fleet.wire.ModelRecord;
import org.evoloop.fleet.wire.Topic;

/**
 * Presses lamps once each, at an even pace.
 *
 * <p>Threading: for one thread.
 *
 * @since 0.1
 */
public final class Presses implements AutoCloseable {
    private static final int PARTITIONS = 4;
    private static final Duration LIMIT = Duration.ofMinutes(2);

    private final Edge edge;

    /** Creates the topics and lamps; an instance of the fleet has to be started separately. */
    public Presses(KafkaCluster cluster, String fleet, ModelRecord lamp, int lamps) {
        try (FleetTopics topics = new FleetTopics(cluster, fleet)) {
            topics.create(PARTITIONS);
        }
        Model compiled = ModelRecord.read("lamp", lamp.bytes());
        edge = new Edge(cluster, fleet, compiled.rules().table().models().original(), lamps, Set.of());
        edge.write(Topic.MODELS, "lamp", lamp.bytes());
        edge.register("lamp");
    }

    /** Presses each lamp once; returns the times until the commands arrived. */
    public Latencies pressEachOnce(int perSecond) {
        await(() -> edge.byModel().getOrDefault("lamp", 0) == edge.size());
        long begun = System.nanoTime();
        for (int pressed = 0; pressed < edge.size(); ) {
            long due = (System.nanoTime() - begun) * perSecond / 1_000_000_000L;
            for (; pressed < Math.min(due, edge.size()); pressed++) {
                edge.press(pressed);
            }
            edge.poll(Duration.ofMillis(1));
        }
        await(() -> edge.latencies().size() == edge.size());
        return edge.latencies();
    }

    private void await(BooleanSupplier enough) {
        long begun = System.nanoTime();
        while (!enough.getAsBoolean()) {
            if (System.nanoTime() - begun > LIMIT.toNanos()) {
                throw new FleetException("not all lamps got their command within " + LIMIT);
            }
            edge.poll(Duration.ofMillis(5));
        }
    }

    @Override
    public void close() {
        edge.close();
    }
}
