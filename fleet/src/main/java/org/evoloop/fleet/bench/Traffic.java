package org.evoloop.fleet.bench;

import java.util.Map;
import java.util.concurrent.Future;
import org.apache.kafka.clients.producer.KafkaProducer;
import org.apache.kafka.clients.producer.ProducerConfig;
import org.apache.kafka.clients.producer.ProducerRecord;
import org.apache.kafka.clients.producer.RecordMetadata;
import org.evoloop.evolution.Occurrence;
import org.evoloop.evolution.Source;
import org.evoloop.evolution.Values;
import org.evoloop.fleet.device.Answer;
import org.evoloop.fleet.stream.KafkaCluster;
import org.evoloop.fleet.wire.Topic;
import org.evoloop.fleet.wire.Wire;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.State;

/**
 * The records of lamps, written before the measurement: each lamp is pressed, answers the command that follows, and is
 * switched off by hand, repeatedly.
 */
final class Traffic implements AutoCloseable {
    private static final Event SWITCH = new Event("switch");
    private static final State OFF = new State("off");
    static final int CYCLE = 3;

    private final String fleet;
    private final int devices;
    private final KafkaProducer<String, byte[]> producer;
    private final byte[] step;
    private final int[] sequence;
    private long millis = System.currentTimeMillis() - 3_600_000;

    Traffic(KafkaCluster cluster, String fleet, int devices) {
        this.fleet = fleet;
        this.devices = devices;
        this.step = new byte[devices];
        this.sequence = new int[devices];
        this.producer = cluster.producer(Map.of(
                ProducerConfig.LINGER_MS_CONFIG, 20,
                ProducerConfig.BATCH_SIZE_CONFIG, 200_000,
                ProducerConfig.COMPRESSION_TYPE_CONFIG, "lz4"));
    }

    static String id(int device) {
        return "lamp-" + device;
    }

    static Occurrence press(long atNanos) {
        return new Occurrence.Heard(SWITCH, Values.NONE, Source.CONTROLLER, Occurrence.ANY_VISIT, atNanos);
    }

    static Answer sent(long sequence, long atNanos) {
        return new Answer(sequence, Answer.Outcome.SENT, "", null, atNanos);
    }

    static Occurrence switchedOff(long atNanos) {
        return new Occurrence.Found(OFF, atNanos);
    }

    void write(Topic topic, String key, byte[] record, long timestamp) {
        Future<RecordMetadata> sent =
                producer.send(new ProducerRecord<>(topic.of(fleet), null, timestamp, key, record));
        if (sent.isCancelled()) {
            throw new IllegalStateException("a record was not written");
        }
    }

    void register(String model) {
        for (int device = 0; device < devices; device++) {
            write(Topic.DEVICES, id(device), Wire.device(model), millis);
        }
        producer.flush();
    }

    /** Writes {@code records} records, for one device after the other. */
    void happen(int records) {
        for (int each = 0; each < records; each++) {
            int device = each % devices;
            if (device == 0) {
                millis++;
            }
            long at = Wire.nanos(millis);
            String id = id(device);
            if (step[device] == 0) {
                write(Topic.OCCURRENCES, id, Wire.occurrence(press(at), 0), millis);
            } else if (step[device] == 1) {
                sequence[device]++;
                write(Topic.EFFECTS, id, Wire.effect(sent(sequence[device], at)), millis);
            } else {
                write(Topic.OCCURRENCES, id, Wire.occurrence(switchedOff(at), 0), millis);
            }
            step[device] = (byte) ((step[device] + 1) % CYCLE);
        }
        producer.flush();
    }

    @Override
    public void close() {
        producer.close();
    }
}
