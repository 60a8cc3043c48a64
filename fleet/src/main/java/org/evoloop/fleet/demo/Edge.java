package org.evoloop.fleet.demo;

import java.time.Duration;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.concurrent.Future;
import org.apache.kafka.clients.consumer.ConsumerConfig;
import org.apache.kafka.clients.consumer.ConsumerRecord;
import org.apache.kafka.clients.consumer.KafkaConsumer;
import org.apache.kafka.clients.producer.KafkaProducer;
import org.apache.kafka.clients.producer.ProducerConfig;
import org.apache.kafka.clients.producer.ProducerRecord;
import org.apache.kafka.clients.producer.RecordMetadata;
import org.apache.kafka.common.PartitionInfo;
import org.apache.kafka.common.TopicPartition;
import org.evoloop.evolution.Occurrence;
import org.evoloop.evolution.Source;
import org.evoloop.evolution.Values;
import org.evoloop.fleet.device.Answer;
import org.evoloop.fleet.device.Order;
import org.evoloop.fleet.stream.KafkaCluster;
import org.evoloop.fleet.wire.Reading;
import org.evoloop.fleet.wire.Topic;
import org.evoloop.fleet.wire.Wire;
import org.evoloop.payload.JsonRecord;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.StateMachine;
import org.jspecify.annotations.Nullable;

/**
 * Simulated lamps connected to a fleet's topics: publishes their presses, and carries out and counts the commands.
 *
 * <p>Threading: for one thread.
 */
final class Edge implements AutoCloseable {
    private static final Event SWITCH = new Event("switch");

    /**
     * At most one request is in flight. Presses are not numbered, so the fleet decides a press twice if it is written
     * twice. After a kill, a broker recognises only a producer's last batch when it is sent again.
     */
    static final Map<String, Object> PRODUCER =
            Map.of(ProducerConfig.LINGER_MS_CONFIG, 2, ProducerConfig.MAX_IN_FLIGHT_REQUESTS_PER_CONNECTION, 1);

    private final String fleet;
    private final KafkaProducer<String, byte[]> producer;
    private final KafkaConsumer<String, byte[]> consumer;
    private final Map<String, SimulatedLamp> lamps = new LinkedHashMap<>();
    private final List<String> ids = new ArrayList<>();
    private final long[] lastPresses;
    private final Counts counts = new Counts();
    private final Latencies latencies = new Latencies();
    private final Set<String> brokenModels;
    private final List<String> deadLetters = new ArrayList<>();
    private String stopped = "";
    private volatile @Nullable Exception failure;

    /** The counts since the start of the demo. */
    static final class Counts {
        long pressed;
        long commands;
        long failed;
        long decisions;
        long timers;
        long switches;
        long deadLetters;
    }

    Edge(KafkaCluster cluster, String fleet, StateMachine lamp, int number, Set<String> brokenModels) {
        this.fleet = fleet;
        this.brokenModels = brokenModels;
        this.lastPresses = new long[number];
        this.producer = cluster.producer(PRODUCER);
        this.consumer = cluster.consumer(Map.of(
                ConsumerConfig.ISOLATION_LEVEL_CONFIG, "read_committed",
                ConsumerConfig.FETCH_MAX_WAIT_MS_CONFIG, 10,
                ConsumerConfig.AUTO_OFFSET_RESET_CONFIG, "earliest"));
        List<TopicPartition> all = new ArrayList<>();
        for (Topic topic : List.of(Topic.COMMANDS, Topic.DECISIONS, Topic.STATES, Topic.DEAD_LETTERS, Topic.ROLLOUTS)) {
            for (PartitionInfo each : consumer.partitionsFor(topic.of(fleet))) {
                all.add(new TopicPartition(each.topic(), each.partition()));
            }
        }
        consumer.assign(all);
        for (int each = 1; each <= number; each++) {
            String id = "lamp-" + each;
            ids.add(id);
            lamps.put(id, new SimulatedLamp(lamp));
        }
    }

    void write(Topic topic, String key, byte[] record) {
        Future<RecordMetadata> sent = producer.send(new ProducerRecord<>(topic.of(fleet), key, record), (at, cause) -> {
            if (cause != null) {
                failure = cause;
            }
        });
        Exception cause = failure;
        if (cause != null) {
            throw new IllegalStateException("a record was not written, " + sent, cause);
        }
    }

    void register(String model) {
        ids.forEach(id -> write(Topic.DEVICES, id, Wire.device(model)));
        producer.flush();
    }

    /** Presses the switch of a lamp, at a time that no other press of it has, so that decisions can be told apart. */
    void press(int lamp) {
        String id = ids.get(lamp);
        long now = Math.max(nowNanos(), lastPresses[lamp] + Wire.nanos(1));
        lastPresses[lamp] = now;
        Occurrence press = new Occurrence.Heard(SWITCH, Values.NONE, Source.CONTROLLER, Occurrence.ANY_VISIT, now);
        write(Topic.OCCURRENCES, id, Wire.occurrence(press, 0));
        SimulatedLamp pressed = lamps.get(id);
        if (pressed != null) {
            pressed.pressed(now);
        }
        counts.pressed++;
    }

    /** Handles new records; waits at most {@code limit} if there are none. */
    void poll(Duration limit) {
        for (ConsumerRecord<String, byte[]> record : consumer.poll(limit)) {
            SimulatedLamp lamp = lamps.get(record.key());
            if (record.topic().equals(Topic.ROLLOUTS.of(fleet))) {
                stopped = Reading.of(record.value()).record().text("stopped", "");
            } else if (record.topic().equals(Topic.DEAD_LETTERS.of(fleet))) {
                counts.deadLetters++;
                JsonRecord letter = Reading.of(record.value()).record();
                deadLetters.add(record.key() + ": " + letter.text("reason") + ", " + letter.text("detail"));
            } else if (lamp != null) {
                take(record, lamp);
            }
        }
    }

    private void take(ConsumerRecord<String, byte[]> record, SimulatedLamp lamp) {
        Reading reading = Reading.of(record.value());
        JsonRecord members = reading.record();
        if (record.topic().equals(Topic.COMMANDS.of(fleet))) {
            obey(record.key(), lamp, reading.order());
        } else if (record.topic().equals(Topic.STATES.of(fleet))) {
            lamp.shownAs(members.text("model"), members.text("device"), members.text("system"));
            members.inner("timersMillis").ifPresent(timers -> lamp.due(timers.number("timeout")));
        } else {
            counts.decisions++;
            counts.switches += members.text("occurrence", "").equals(SWITCH.name()) ? 1 : 0;
            counts.failed += members.text("outcome").equals("failed") ? 1 : 0;
            if (members.text("source", "").equals("timer")) {
                counts.timers++;
                lamp.fired(members.number("atMillis"));
            }
        }
    }

    private void obey(String id, SimulatedLamp lamp, Order order) {
        counts.commands++;
        long now = nowNanos();
        long pressed = lamp.takePress();
        if (pressed > 0) {
            latencies.add(Wire.millis(now - pressed));
        }
        Answer answer = lamp.obey(order, now, brokenModels.contains(lamp.model()));
        if (answer != null) {
            write(Topic.EFFECTS, id, Wire.effect(answer));
        }
    }

    static long nowNanos() {
        return Wire.nanos(System.currentTimeMillis());
    }

    Counts counts() {
        return counts;
    }

    Latencies latencies() {
        return latencies;
    }

    List<String> deadLetters() {
        return deadLetters;
    }

    /** Why the last rollout was stopped; empty if it was not. */
    String stopped() {
        return stopped;
    }

    int size() {
        return ids.size();
    }

    /** The number of lamps by model version. */
    Map<String, Integer> byModel() {
        Map<String, Integer> byModel = new TreeMap<>();
        lamps.values().forEach(lamp -> byModel.merge(lamp.model(), 1, Integer::sum));
        byModel.remove("");
        return byModel;
    }

    /** The number of commands received twice. */
    int repeated() {
        return lamps.values().stream().mapToInt(SimulatedLamp::repeated).sum();
    }

    /** The number of lamps in another state than the fleet shows. */
    long elsewhere() {
        return lamps.values().stream().filter(lamp -> !lamp.isWhereItIsShown()).count();
    }

    /** The number of lamps that wait for a timer. */
    long waiting() {
        return lamps.values().stream().filter(SimulatedLamp::isWaiting).count();
    }

    /** The number of timers that fired before they were due. */
    long early() {
        return lamps.values().stream().mapToLong(SimulatedLamp::early).sum();
    }

    /** The number of commands sent by the fleet, according to their sequence numbers. */
    long sequences() {
        return lamps.values().stream().mapToLong(SimulatedLamp::sequence).sum();
    }

    @Override
    public void close() {
        producer.close(Duration.ofSeconds(5));
        consumer.close();
    }
}
