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

/** A fleet of one instance that runs by the wall clock, with its topics. */
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
        Fleet next = new Fleet(Brokers.shared(), settings.withStateDirectory(directory));
        next.start();
        assertThat(next.awaitRunning(Duration.ofMinutes(1))).isTrue();
        return next;
    }

    /** Another instance, which has nothing on its disk, takes the place of this one. */
    void restart(Path directory) throws Exception {
        fleet.close();
        fleet = started(directory);
    }

    /** Publishes models, and waits until a device can have them. */
    void publish(String version, byte[] record) {
        cluster.write(Topic.MODELS, version, record);
        cluster.flush();
        String probe = "probe-" + version;
        // What is published reaches the instances a moment later; nobody is told when.
        do {
            cluster.write(Topic.DEVICES, probe, Wire.device(version));
            int before = cluster.told().size();
            cluster.readUntil(told -> told.size() > before);
        } while (cluster.told().of(Topic.STATES, probe).isEmpty());
    }

    void register(String device, String version) {
        cluster.write(Topic.DEVICES, device, Wire.device(version));
        cluster.readUntil(told -> !told.of(Topic.STATES, device).isEmpty());
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

    /** Waits for the command of this number, and answers it. */
    void answer(String device, int sequence, Answer.Outcome outcome) {
        cluster.readUntil(told -> told.of(Topic.COMMANDS, device).size() >= sequence);
        Answer answer = new Answer(sequence, outcome, "as the test wants it", null, nowNanos());
        cluster.write(Topic.EFFECTS, device, Wire.effect(answer));
    }

    @Override
    public void close() {
        fleet.close();
        cluster.close();
    }
}
