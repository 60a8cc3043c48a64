package org.evoloop.fleet.stream;

import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.NoSuchElementException;
import org.apache.kafka.common.utils.Bytes;
import org.apache.kafka.streams.KeyValue;
import org.apache.kafka.streams.processor.StateStore;
import org.apache.kafka.streams.processor.StateStoreContext;
import org.apache.kafka.streams.query.Position;
import org.apache.kafka.streams.state.KeyValueBytesStoreSupplier;
import org.apache.kafka.streams.state.KeyValueIterator;
import org.apache.kafka.streams.state.KeyValueStore;
import org.jspecify.annotations.Nullable;

/**
 * A store in memory that finds a key by its hash. The one of Kafka Streams is a sorted tree, in which finding one of a
 * million keys takes several times as long as finding one of a thousand.
 *
 * <p>A value overwrites the previous one of its key if both have about the same length. Otherwise every replaced value
 * would become garbage in the old generation, which is expensive to collect.
 *
 * <p>Iterators are in the order of the keys. They return the keys that existed when they were created, with their current
 * values.
 *
 * <p>Threading: thread-safe.
 */
final class MemoryStore implements KeyValueStore<Bytes, byte[]> {
    private static final int ROUND = 16;

    private final String name;

    /** Each in an array whose length is a multiple of {@value #ROUND}; its last byte is the number of unused bytes. */
    private final Map<Bytes, byte[]> values = new HashMap<>();

    /** All keys in order; null if keys have been added or removed since it was created. */
    private Bytes @Nullable [] order;

    private volatile boolean open;

    private MemoryStore(String name) {
        this.name = name;
    }

    /** Supplies stores of this name. */
    static KeyValueBytesStoreSupplier supplier(String name) {
        return new KeyValueBytesStoreSupplier() {
            @Override
            public String name() {
                return name;
            }

            @Override
            public KeyValueStore<Bytes, byte[]> get() {
                return new MemoryStore(name);
            }

            @Override
            public String metricsScope() {
                return "memory";
            }
        };
    }

    @Override
    public String name() {
        return name;
    }

    @Override
    public void init(StateStoreContext context, StateStore root) {
        context.register(root, (key, value) -> put(Bytes.wrap(key), value));
        open = true;
    }

    /** Keeps nothing: when it is opened again, Kafka Streams restores it from its topic. */
    @Override
    public synchronized void close() {
        open = false;
        values.clear();
        order = null;
    }

    @Override
    public boolean isOpen() {
        return open;
    }

    @Override
    public boolean persistent() {
        return false;
    }

    @Override
    public Position getPosition() {
        return Position.emptyPosition();
    }

    @Override
    public synchronized byte @Nullable [] get(Bytes key) {
        byte[] kept = values.get(key);
        return kept == null ? null : Arrays.copyOf(kept, kept.length - kept[kept.length - 1]);
    }

    @Override
    public synchronized void put(Bytes key, byte @Nullable [] value) {
        if (value == null) {
            if (values.remove(key) != null) {
                order = null;
            }
            return;
        }
        byte[] kept = values.get(key);
        int length = (value.length / ROUND + 1) * ROUND;
        if (kept == null || kept.length != length) {
            kept = new byte[length];
            if (values.put(key, kept) == null) {
                order = null;
            }
        }
        System.arraycopy(value, 0, kept, 0, value.length);
        kept[length - 1] = (byte) (length - value.length);
    }

    @Override
    public synchronized byte @Nullable [] putIfAbsent(Bytes key, byte[] value) {
        byte[] known = get(key);
        if (known == null) {
            put(key, value);
        }
        return known;
    }

    @Override
    public synchronized void putAll(List<KeyValue<Bytes, byte[]>> entries) {
        entries.forEach(entry -> put(entry.key, entry.value));
    }

    @Override
    public synchronized byte @Nullable [] delete(Bytes key) {
        byte[] known = get(key);
        put(key, null);
        return known;
    }

    @Override
    public synchronized long approximateNumEntries() {
        return values.size();
    }

    @Override
    public KeyValueIterator<Bytes, byte[]> all() {
        return range(null, null);
    }

    @Override
    public KeyValueIterator<Bytes, byte[]> range(@Nullable Bytes from, @Nullable Bytes to) {
        Bytes[] keys = inOrder();
        return new InOrder(keys, from == null ? 0 : place(keys, from), to);
    }

    private static int place(Bytes[] keys, Bytes key) {
        int found = Arrays.binarySearch(keys, key);
        return found < 0 ? -found - 1 : found;
    }

    private synchronized Bytes[] inOrder() {
        Bytes[] keys = order;
        if (keys == null) {
            keys = values.keySet().toArray(Bytes[]::new);
            Arrays.sort(keys);
            order = keys;
        }
        return keys;
    }

    private final class InOrder implements KeyValueIterator<Bytes, byte[]> {
        private final Bytes[] keys;
        private final @Nullable Bytes last;
        private int at;
        private @Nullable KeyValue<Bytes, byte[]> next;

        InOrder(Bytes[] keys, int at, @Nullable Bytes last) {
            this.keys = keys;
            this.at = at;
            this.last = last;
        }

        /** Skips keys that have been removed. */
        private @Nullable KeyValue<Bytes, byte[]> peek() {
            while (next == null && at < keys.length && (last == null || keys[at].compareTo(last) <= 0)) {
                Bytes key = keys[at++];
                byte[] value = get(key);
                next = value == null ? null : new KeyValue<>(key, value);
            }
            return next;
        }

        @Override
        public boolean hasNext() {
            return peek() != null;
        }

        @Override
        public KeyValue<Bytes, byte[]> next() {
            KeyValue<Bytes, byte[]> found = peek();
            if (found == null) {
                throw new NoSuchElementException();
            }
            next = null;
            return found;
        }

        @Override
        public Bytes peekNextKey() {
            KeyValue<Bytes, byte[]> found = peek();
            if (found == null) {
                throw new NoSuchElementException();
            }
            return found.key;
        }

        @Override
        public void close() {}
    }
}
