package org.evoloop.fleet.stream;

import java.util.LinkedHashMap;
import java.util.Map;
import java.util.function.BiPredicate;
import java.util.function.ObjLongConsumer;
import org.apache.kafka.streams.KeyValue;
import org.apache.kafka.streams.state.KeyValueIterator;
import org.apache.kafka.streams.state.KeyValueStore;
import org.evoloop.core.text.SnapshotException;
import org.evoloop.fleet.device.Device;
import org.evoloop.fleet.device.DeviceState;
import org.evoloop.fleet.device.DeviceStateBytes;
import org.evoloop.fleet.wire.Refusal;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * What is kept of the devices of one partition: the store's bytes, and those that were met last as they are read from
 * it.
 */
final class Devices {
    private static final Logger LOG = LoggerFactory.getLogger(Devices.class);

    private final KeyValueStore<String, byte[]> store;
    private final Library library;
    private final Map<String, DeviceState> recent = new Recent();

    /** Reading a device's bytes takes longer than all else that is done with it. */
    private static final class Recent extends LinkedHashMap<String, DeviceState> {
        private static final int MOST = 10_000;
        private static final float LOAD = 0.75f;

        Recent() {
            super(1_024, LOAD, true);
        }

        @Override
        protected boolean removeEldestEntry(Map.Entry<String, DeviceState> eldest) {
            return size() > MOST;
        }
    }

    Devices(KeyValueStore<String, byte[]> store, Library library) {
        this.store = store;
        this.library = library;
    }

    /**
     * What is kept of {@code id}; null if it was not registered.
     *
     * @throws Refusal if that does not fit the device's models, or there are no such models any more
     */
    @Nullable
    DeviceState get(String id) {
        DeviceState kept = recent.get(id);
        if (kept == null) {
            byte[] bytes = store.get(id);
            if (bytes == null) {
                return null;
            }
            kept = read(bytes);
            recent.put(id, kept);
        }
        return kept;
    }

    private DeviceState read(byte[] bytes) {
        try {
            return DeviceStateBytes.read(
                    library.model(DeviceStateBytes.model(bytes)).rules(), bytes);
        } catch (SnapshotException | IllegalArgumentException e) {
            throw new Refusal(Refusal.Reason.UNUSABLE_STATE, "what is kept of the device: " + e.getMessage());
        }
    }

    void put(String id, DeviceState kept) {
        store.put(id, DeviceStateBytes.write(kept));
        recent.put(id, kept);
    }

    void remove(String id) {
        store.delete(id);
        recent.remove(id);
    }

    /** Tells when something is due at each of them. */
    void eachDue(long patienceNanos, ObjLongConsumer<String> told) {
        try (KeyValueIterator<String, byte[]> each = store.all()) {
            while (each.hasNext()) {
                KeyValue<String, byte[]> next = each.next();
                try {
                    told.accept(next.key, Device.dueNanos(read(next.value), patienceNanos));
                } catch (Refusal refusal) {
                    LOG.error("nothing will be due at the device {}: {}", next.key, refusal.detail());
                }
            }
        }
    }

    /**
     * Looks at {@code most} devices, in the order of their ids.
     *
     * @param from the first id; null for the very first
     * @param wanted told an id and the version of the models there; whether it is of interest
     * @param found told those of interest
     * @return where to go on; null if all were looked at
     */
    @Nullable
    String walk(@Nullable String from, int most, BiPredicate<String, String> wanted, Told found) {
        String last = null;
        int looked = 0;
        try (KeyValueIterator<String, byte[]> each = store.range(from, null)) {
            while (each.hasNext() && looked < most) {
                KeyValue<String, byte[]> next = each.next();
                last = next.key;
                looked++;
                if (wanted.test(next.key, version(next.value))) {
                    found.device(next.key);
                }
            }
        }
        return looked < most || last == null ? null : last + '\0';
    }

    /** Of bytes that cannot be read, none: that is told when something happens at the device. */
    private static String version(byte[] bytes) {
        try {
            return DeviceStateBytes.model(bytes);
        } catch (IllegalArgumentException unreadable) {
            return "";
        }
    }

    /** Who is told of devices. */
    interface Told {
        void device(String id);
    }
}
