package org.evoloop.fleet.bench;

import java.util.EnumSet;
import java.util.Set;
import org.apache.kafka.common.serialization.Serdes;
import org.apache.kafka.streams.AutoOffsetReset;
import org.apache.kafka.streams.Topology;
import org.apache.kafka.streams.processor.api.Processor;
import org.apache.kafka.streams.processor.api.ProcessorContext;
import org.apache.kafka.streams.processor.api.Record;
import org.apache.kafka.streams.state.KeyValueStore;
import org.evoloop.fleet.stream.FleetSettings;
import org.evoloop.fleet.stream.FleetTopology;
import org.evoloop.fleet.wire.Letters;
import org.evoloop.fleet.wire.Topic;

/**
 * Measures the cost of Kafka Streams alone: for each record, the device's bytes are read and replaced, and records are
 * written. Bytes and records are those of the fleet, but made beforehand.
 */
final class PassThrough implements Processor<String, byte[], String, byte[]> {
    private static final String STORE = "devices";
    private static final Set<Topic> IN = EnumSet.of(Topic.DEVICES, Topic.OCCURRENCES, Topic.EFFECTS);
    private static final Set<Topic> OUT = EnumSet.of(Topic.COMMANDS, Topic.DECISIONS, Topic.STATES);

    private final Exchange exchange;
    private ProcessorContext<String, byte[]> context;
    private KeyValueStore<String, byte[]> store;

    @SuppressWarnings("NullAway.Init") // init comes before all else
    private PassThrough(Exchange exchange) {
        this.exchange = exchange;
    }

    static Topology topology(FleetSettings settings, Exchange exchange) {
        String fleet = settings.fleet();
        Topology topology = new Topology();
        for (Topic topic : IN) {
            topology.addSource(
                    AutoOffsetReset.earliest(),
                    "from-" + topic,
                    Serdes.String().deserializer(),
                    Serdes.ByteArray().deserializer(),
                    topic.of(fleet));
        }
        topology.addProcessor(
                "pass-through",
                () -> new PassThrough(exchange),
                IN.stream().map(topic -> "from-" + topic).toArray(String[]::new));
        topology.addStateStore(FleetTopology.devices(settings), "pass-through");
        for (Topic topic : OUT) {
            topology.addSink(
                    topic.name(),
                    topic.of(fleet),
                    Serdes.String().serializer(),
                    Serdes.ByteArray().serializer(),
                    "pass-through");
        }
        return topology;
    }

    @Override
    public void init(ProcessorContext<String, byte[]> given) {
        context = given;
        store = given.getStateStore(STORE);
    }

    /** The first of a device's bytes holds the number of its last step. */
    @Override
    public void process(Record<String, byte[]> record) {
        byte[] known = store.get(record.key());
        int number = known == null ? 0 : exchange.after(known[0]);
        Exchange.Step step = exchange.steps().get(number);
        byte[] stored = step.stored().clone();
        stored[0] = (byte) number;
        store.put(record.key(), stored);
        for (Letters.Letter letter : step.letters()) {
            context.forward(
                    new Record<>(record.key(), letter.text(), record.timestamp()),
                    letter.topic().name());
        }
    }
}
