package org.evoloop.fleet.stream;

import java.util.EnumSet;
import java.util.HashMap;
import java.util.Map;
import java.util.Set;
import org.apache.kafka.common.serialization.Serdes;
import org.apache.kafka.streams.AutoOffsetReset;
import org.apache.kafka.streams.Topology;
import org.apache.kafka.streams.processor.api.Processor;
import org.apache.kafka.streams.processor.api.ProcessorContext;
import org.apache.kafka.streams.processor.api.Record;
import org.apache.kafka.streams.state.KeyValueBytesStoreSupplier;
import org.apache.kafka.streams.state.KeyValueStore;
import org.apache.kafka.streams.state.StoreBuilder;
import org.apache.kafka.streams.state.Stores;
import org.evoloop.fleet.wire.Topic;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * The topology of topics and processors.
 *
 * @since 0.1
 */
public final class FleetTopology {
    private static final Logger LOG = LoggerFactory.getLogger(FleetTopology.class);
    private static final String DEVICE = "device";
    private static final String WATCH = "rollout-watch";
    private static final Set<Topic> IN = EnumSet.of(Topic.DEVICES, Topic.OCCURRENCES, Topic.EFFECTS);
    private static final Set<Topic> OUT =
            EnumSet.of(Topic.COMMANDS, Topic.DECISIONS, Topic.STATES, Topic.DEAD_LETTERS, Topic.VERDICTS);

    private FleetTopology() {}

    /** The topology of the fleet named in {@code settings}. */
    public static Topology of(FleetSettings settings) {
        return of(settings, new FleetCounts());
    }

    static Topology of(FleetSettings settings, FleetCounts counts) {
        Topology topology = new Topology();
        Map<String, Topic> topics = new HashMap<>();
        for (Topic topic : IN) {
            topics.put(topic.of(settings.fleet()), topic);
            source(topology, topic, settings);
        }
        topology.addProcessor(
                DEVICE,
                () -> new DeviceProcessor(settings, topics, counts),
                IN.stream().map(FleetTopology::sourceOf).toArray(String[]::new));
        topology.addStateStore(devices(settings), DEVICE);
        for (Topic topic : OUT) {
            sink(topology, topic, settings, DEVICE);
        }
        source(topology, Topic.VERDICTS, settings);
        topology.addProcessor(WATCH, RolloutWatch::new, sourceOf(Topic.VERDICTS));
        topology.addStateStore(store(RolloutWatch.STORE, true), WATCH);
        sink(topology, Topic.ROLLOUTS, settings, WATCH);
        global(topology, Topic.MODELS, DeviceProcessor.MODELS, settings);
        global(topology, Topic.ROLLOUTS, DeviceProcessor.ROLLOUTS, settings);
        return topology;
    }

    /**
     * The store of the devices. It has no cache: a device gets a command only after a commit, so its state rarely changes
     * twice between two commits.
     */
    public static StoreBuilder<KeyValueStore<String, byte[]>> devices(FleetSettings settings) {
        return store(DeviceProcessor.STORE, settings.isInMemory());
    }

    private static String sourceOf(Topic topic) {
        return "from-" + topic.name();
    }

    private static void source(Topology topology, Topic topic, FleetSettings settings) {
        topology.addSource(
                AutoOffsetReset.earliest(),
                sourceOf(topic),
                Serdes.String().deserializer(),
                Serdes.ByteArray().deserializer(),
                topic.of(settings.fleet()));
    }

    private static void sink(Topology topology, Topic topic, FleetSettings settings, String from) {
        topology.addSink(
                topic.name(),
                topic.of(settings.fleet()),
                Serdes.String().serializer(),
                Serdes.ByteArray().serializer(),
                from);
    }

    private static StoreBuilder<KeyValueStore<String, byte[]>> store(String name, boolean inMemory) {
        KeyValueBytesStoreSupplier supplier =
                inMemory ? MemoryStore.supplier(name) : Stores.persistentKeyValueStore(name);
        return Stores.keyValueStoreBuilder(supplier, Serdes.String(), Serdes.ByteArray());
    }

    /** A copy of a whole topic in every instance. */
    private static void global(Topology topology, Topic topic, String name, FleetSettings settings) {
        topology.addGlobalStore(
                store(name, true).withLoggingDisabled(),
                sourceOf(topic),
                Serdes.String().deserializer(),
                Serdes.ByteArray().deserializer(),
                topic.of(settings.fleet()),
                "keep-" + name,
                () -> new Copy(name));
    }

    private static final class Copy implements Processor<String, byte[], Void, Void> {
        private final String name;
        private KeyValueStore<String, byte[]> store;

        @SuppressWarnings("NullAway.Init") // init comes before all else
        Copy(String name) {
            this.name = name;
        }

        @Override
        public void init(ProcessorContext<Void, Void> context) {
            store = context.getStateStore(name);
        }

        @Override
        public void process(Record<String, byte[]> record) {
            if (record.key() == null) {
                // Only a topic that was created without compaction can have one. An exception would end the instance.
                LOG.error("a record for {} is ignored: it has no key", name);
                return;
            }
            store.put(record.key(), record.value());
        }
    }
}
