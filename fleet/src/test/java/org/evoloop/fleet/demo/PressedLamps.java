package org.evoloop.fleet.demo;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.util.Random;
import java.util.Set;
import java.util.function.BooleanSupplier;
import org.evoloop.fleet.device.Model;
import org.evoloop.fleet.stream.FleetTopics;
import org.evoloop.fleet.stream.KafkaCluster;
import org.evoloop.fleet.wire.ModelRecord;
import org.evoloop.fleet.wire.Topic;
import org.evoloop.statemachine.StateMachine;

/** Lamps that are pressed during failures, and the assertions that must hold afterwards. */
final class PressedLamps implements AutoCloseable {
    private static final Duration LIMIT = Duration.ofMinutes(4);

    private final String bootstrap;
    private final String fleet;
    private final Edge edge;
    private final Random random = new Random(7);

    PressedLamps(String bootstrap, String fleet, int number, ModelRecord models) {
        this.bootstrap = bootstrap;
        this.fleet = fleet;
        try (FleetTopics topics = new FleetTopics(KafkaCluster.at(bootstrap), fleet)) {
            topics.create(3);
        }
        Model lamp = ModelRecord.read("lamp-1", models.bytes());
        StateMachine device = lamp.rules().table().models().original();
        edge = new Edge(KafkaCluster.at(bootstrap), fleet, device, number, Set.of());
        edge.write(Topic.MODELS, "lamp-1", models.bytes());
    }

    void register() {
        edge.register("lamp-1");
        await(() -> edge.byModel().getOrDefault("lamp-1", 0) == edge.size());
    }

    /** Presses {@code times} times, one after the other. */
    void press(int times) {
        for (int each = 0; each < times; each++) {
            edge.press(random.nextInt(edge.size()));
            edge.poll(Duration.ofMillis(1));
        }
    }

    long pressed() {
        return edge.counts().pressed;
    }

    /** Waits until {@code presses} presses are decided. */
    void awaitDecided(long presses) {
        await(() -> edge.counts().switches >= presses);
    }

    /** Waits until all expected records have arrived, and checks them. */
    void settle() {
        await(() -> edge.counts().switches >= edge.counts().pressed && edge.elsewhere() == 0 && edge.waiting() == 0);
        TopicAudit topics = TopicAudit.of(bootstrap, fleet);
        assertThat(topics.problems()).as("the topics:\n" + topics).isEmpty();
        assertThat(edge.counts().switches)
                .as("presses decided; the topics:\n" + topics)
                .isEqualTo(edge.counts().pressed);
        assertThat(edge.repeated()).as("commands that came twice").isZero();
        assertThat(edge.counts().commands).as("no command is left out").isEqualTo(edge.sequences());
        assertThat(edge.counts().timers).as("timers").isPositive();
        assertThat(edge.early()).as("timers that fired early").isZero();
    }

    private void await(BooleanSupplier enough) {
        long begun = System.nanoTime();
        while (!enough.getAsBoolean()) {
            if (System.nanoTime() - begun > LIMIT.toNanos()) {
                throw new AssertionError("not within " + LIMIT + ": " + edge.counts().pressed + " pressed, "
                        + edge.counts().switches + " decided, " + edge.elsewhere() + " elsewhere, " + edge.waiting()
                        + " waiting for a timer; the topics:\n" + TopicAudit.of(bootstrap, fleet));
            }
            edge.poll(Duration.ofMillis(50));
        }
    }

    @Override
    public void close() {
        edge.close();
    }
}
