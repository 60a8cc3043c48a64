package org.evoloop.fleet.stream;

import java.util.function.BiPredicate;
import java.util.function.Consumer;
import java.util.function.ObjLongConsumer;
import org.apache.kafka.streams.KeyValue;
import org.apache.kafka.streams.state.KeyValueIterator;
import org.apache.kafka.streams.state.KeyValueStore;
import org.evoloop.engine.Rules;
import org.evoloop.engine.codec.CodecException;
import org.evoloop.fleet.device.Device;
import org.evoloop.fleet.device.DeviceState;
import org.evoloop.fleet.device.DeviceStateBytes;
import org.evoloop.fleet.device.Past;
import org.evoloop.fleet.wire.Refusal;
import org.evoloop.fleet.wire.Wire;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * The stored states of one partition's devices: bytes in the store, with a cache of parsed states.
 */
final class Devices {
    private static final Logger LOG = LoggerFactory.getLogger(Devices.class);

    private final KeyValueStore<String, byte[]> store;
    private final Library library;
    private final Recent recent = new Recent();

    /**
     * Recently used states, at most one for each hash of an id: parsing a device's bytes takes longer than handling its
     * record.
     */
    private static final class Recent {
        private static final int PLACES = 1 << 11;

        private final int[] hashes = new int[PLACES];
        private final @Nullable String[] ids = new String[PLACES];
        private final @Nullable DeviceState[] states = new DeviceState[PLACES];

        private static int place(String id) {
            int hash = id.hashCode();
            return (hash ^ hash >>> 16) & (PLACES - 1);
        }

        @Nullable
        DeviceState get(String id) {
            int place = place(id);
            return hashes[place] == id.hashCode() && id.equals(ids[place]) ? states[place] : null;
        }

        void put(String id, @Nullable DeviceState state) {
            int place = place(id);
            hashes[place] = id.hashCode();
            ids[place] = id;
            states[place] = state;
        }
    }

    Devices(KeyValueStore<String, byte[]> store, Library library) {
        this.store = store;
        this.library = library;
    }

    /**
     * The state of {@code id}; null if it was not registered, or was removed.
     *
     * @throws Refusal if the state does not fit the device's models, or these no longer exist
     */
    @Nullable
    DeviceState get(String id) {
        DeviceState state = recent.get(id);
        if (state == null) {
            byte[] bytes = store.get(id);
            if (bytes == null || DeviceStateBytes.isRemoved(bytes)) {
                return null;
            }
            state = read(bytes);
            recent.put(id, state);
        }
        return state;
    }

    private DeviceState read(byte[] bytes) {
        try {
            return DeviceStateBytes.read(version -> library.model(version).rules(), bytes);
        } catch (CodecException | IllegalArgumentException e) {
            throw new Refusal(Refusal.Reason.UNUSABLE_STATE, "the stored state of the device: " + e.getMessage());
        }
    }

    /** @throws Refusal if the state is too large to be stored, such as one with many large events that wait */
    void put(String id, DeviceState state) {
        store.put(id, Wire.requireSendable(DeviceStateBytes.write(state), "the device's stored state"));
        recent.put(id, state);
    }

    /** Removes a device; only its {@linkplain #past numbers} remain. */
    void remove(String id) {
        try {
            DeviceState state = get(id);
            if (state != null) {
                store.put(id, DeviceStateBytes.write(Past.of(state)));
            }
        } catch (Refusal unusable) {
            store.delete(id);
        }
        recent.put(id, null);
    }

    /** What remains of {@code id}, which has no state. */
    Past past(String id) {
        byte[] bytes = store.get(id);
        return bytes == null ? Past.NONE : DeviceStateBytes.past(bytes);
    }

    /** Passes each device's id, and when something is due there, to {@code consumer}. */
    void eachDue(long patienceNanos, ObjLongConsumer<String> consumer) {
        try (KeyValueIterator<String, byte[]> each = store.all()) {
            while (each.hasNext()) {
                KeyValue<String, byte[]> next = each.next();
                if (DeviceStateBytes.isRemoved(next.value)) {
                    continue;
                }
                try {
                    DeviceState state = read(next.value);
                    Rules rules = library.model(state.model()).rules();
                    consumer.accept(next.key, Device.dueNanos(rules, state, patienceNanos));
                } catch (Refusal refusal) {
                    LOG.error("the timers of the device {} are not watched: {}", next.key, refusal.detail());
                }
            }
        }
    }

    /**
     * Visits at most {@code most} devices, in the order of their ids.
     *
     * @param from the first id; null for the first of all
     * @param wanted selects devices by their id and the version of their models
     * @param found receives the ids of the selected devices
     * @return where to continue; null if all were visited
     */
    @Nullable
    String walk(@Nullable String from, int most, BiPredicate<String, String> wanted, Consumer<String> found) {
        String last = null;
        int looked = 0;
        try (KeyValueIterator<String, byte[]> each = store.range(from, null)) {
            while (each.hasNext() && looked < most) {
                KeyValue<String, byte[]> next = each.next();
                last = next.key;
                looked++;
                if (wanted.test(next.key, version(next.value))) {
                    found.accept(next.key);
                }
            }
        }
        return looked < most || last == null ? null : last + '\0';
    }

    /** Empty if the device was removed, or the bytes cannot be read; the next record for the device reports the error. */
    private static String version(byte[] bytes) {
        try {
            return DeviceStateBytes.model(bytes);
        } catch (CodecException unreadable) {
            return "";
        }
    }
}
