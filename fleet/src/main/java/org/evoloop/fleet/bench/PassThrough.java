package org.evoloop.fleet.bench;

import org.apache.kafka.common.serialization.Serdes;
import org.apache.kafka.streams.AutoOffsetReset;
import org.apache.kafka.streams.Topology;
import org.apache.kafka.streams.processor.api.Processor;
import org.apache.kafka.streams.processor.api.ProcessorContext;
import org.apache.kafka.streams.processor.api.Record;
import org.apache.kafka.streams.state.KeyValueStore;
import org.apache.kafka.streams.state.Stores;
import org.evoloop.fleet.wire.Topic;

/**
 * Measures the cost of Kafka Streams alone: each record reads the device's bytes, writes them back, and is passed on.
 */
final class PassThrough implements Processor<String, byte[], String, byte[]> {
    private static final String STORE = "devices";

    private final byte[] initial;
    private ProcessorContext<String, byte[]> context;
    private KeyValueStore<String, byte[]> store;

    @SuppressWarnings("NullAway.Init") // init comes before all else
    private PassThrough(int storedBytes) {
        this.initial = new byte[storedBytes];
    }

    /** @param storedBytes the bytes stored for a device */
    static Topology topology(String fleet, int storedBytes) {
        Topology topology = new Topology();
        String[] sources = {"devices-in", "occurrences-in", "effects-in"};
        Topic[] topics = {Topic.DEVICES, Topic.OCCURRENCES, Topic.EFFECTS};
        for (int each = 0; each < sources.length; each++) {
            topology.addSource(
                    AutoOffsetReset.earliest(),
                    sources[each],
                    Serdes.String().deserializer(),
                    Serdes.ByteArray().deserializer(),
                    topics[each].of(fleet));
        }
        topology.addProcessor("pass-through", () -> new PassThrough(storedBytes), sources);
        topology.addStateStore(
                Stores.keyValueStoreBuilder(Stores.inMemoryKeyValueStore(STORE), Serdes.String(), Serdes.ByteArray())
                        .withCachingEnabled(),
                "pass-through");
        topology.addSink(
                "out",
                Topic.DECISIONS.of(fleet),
                Serdes.String().serializer(),
                Serdes.ByteArray().serializer(),
                "pass-through");
        return topology;
    }

    @Override
    public void init(ProcessorContext<String, byte[]> given) {
        context = given;
        store = given.getStateStore(STORE);
    }

    @Override
    public void process(Record<String, byte[]> record) {
        byte[] known = store.get(record.key());
        store.put(record.key(), known == null ? initial.clone() : known.clone());
        context.forward(record);
    }
}
