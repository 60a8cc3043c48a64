package org.evoloop.fleet.stream;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.time.Duration;
import java.util.function.UnaryOperator;
import org.evoloop.evolution.Occurrence;
import org.evoloop.evolution.Source;
import org.evoloop.evolution.Values;
import org.evoloop.fleet.Brokers;
import org.evoloop.fleet.Cluster;
import org.evoloop.fleet.device.Answer;
import org.evoloop.fleet.wire.Topic;
import org.evoloop.fleet.wire.Wire;
import org.evoloop.statemachine.Event;

/** A fleet of one instance with the wall clock, and its topics. */
final class RunningFleet implements AutoCloseable {
    final Cluster cluster;
    private final FleetSettings settings;
    private Fleet fleet;

    RunningFleet(Path directory) throws Exception {
        this(directory, settings -> settings);
    }

    RunningFleet(Path directory, UnaryOperator<FleetSettings> change) throws Exception {
        cluster = Cluster.fresh(2);
        settings =
                change.apply(FleetSettings.defaults().withFleet(cluster.fleet()).withPatience(Duration.ofSeconds(60)));
        fleet = started(directory);
    }

    private Fleet started(Path directory) throws Exception {
        Fleet next = new Fleet(KafkaCluster.at(Brokers.shared()), settings.withStateDirectory(directory));
        next.start();
        assertThat(next.awaitRunning(Duration.ofMinutes(1))).isTrue();
        return next;
    }

    /** Replaces this instance by another with an empty disk. */
    void restart(Path directory) throws Exception {
        fleet.close();
        fleet = started(directory);
    }

    /** Publishes models, and waits until devices can use them. */
    void publish(String version, byte[] record) {
        cluster.write(Topic.MODELS, version, record);
        cluster.flush();
        String probe = "probe-" + version;
        // Published models reach the instances a little later, without notice; a probe shows when.
        do {
            cluster.write(Topic.DEVICES, probe, Wire.device(version));
            int before = cluster.records().size();
            cluster.readUntil(records -> records.size() > before);
        } while (cluster.records().of(Topic.STATES, probe).isEmpty());
    }

    void register(String device, String version) {
        cluster.write(Topic.DEVICES, device, Wire.device(version));
        cluster.readUntil(records -> !records.of(Topic.STATES, device).isEmpty());
    }

    static long nowNanos() {
        return Wire.nanos(System.currentTimeMillis());
    }

    static byte[] press(long atNanos) {
        return Wire.occurrence(
                new Occurrence.Heard(
                        new Event("switch"), Values.NONE, Source.CONTROLLER, Occurrence.ANY_VISIT, atNanos),
                0);
    }

    void press(String device) {
        cluster.write(Topic.OCCURRENCES, device, press(nowNanos()));
    }

    /** Waits for the command with this sequence number, and answers it. */
    void answer(String device, int sequence, Answer.Outcome outcome) {
        cluster.readUntil(records -> records.of(Topic.COMMANDS, device).size() >= sequence);
        Answer answer = new Answer(sequence, outcome, "as the test wants it", null, nowNanos());
        cluster.write(Topic.EFFECTS, device, Wire.effect(answer));
    }

    @Override
    public void close() {
        fleet.close();
        cluster.close();
    }
}
