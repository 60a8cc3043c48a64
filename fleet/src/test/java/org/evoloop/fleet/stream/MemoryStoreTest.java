package org.evoloop.fleet.stream;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.NavigableMap;
import java.util.NoSuchElementException;
import java.util.Random;
import java.util.TreeMap;
import org.apache.kafka.common.utils.Bytes;
import org.apache.kafka.streams.KeyValue;
import org.apache.kafka.streams.state.KeyValueIterator;
import org.apache.kafka.streams.state.KeyValueStore;
import org.junit.jupiter.api.Test;

class MemoryStoreTest {
    private final KeyValueStore<Bytes, byte[]> store =
            MemoryStore.supplier("devices").get();

    @Test
    void itHoldsWhatASortedMapHolds() {
        long seed = new Random().nextLong();
        Random random = new Random(seed);
        NavigableMap<Bytes, String> expected = new TreeMap<>();
        for (int step = 0; step < 20_000; step++) {
            Bytes key = key("device-" + random.nextInt(200));
            String value = "x".repeat(random.nextInt(40)) + step;
            switch (random.nextInt(8)) {
                case 0 -> assertThat(text(store.delete(key))).isEqualTo(expected.remove(key));
                case 1 ->
                    assertThat(text(store.putIfAbsent(key, bytes(value)))).isEqualTo(expected.putIfAbsent(key, value));
                case 2 -> {
                    store.putAll(List.of(new KeyValue<>(key, bytes(value))));
                    expected.put(key, value);
                }
                default -> {
                    store.put(key, bytes(value));
                    expected.put(key, value);
                }
            }
            assertThat(text(store.get(key))).as("seed %d", seed).isEqualTo(expected.get(key));
            if (step % 500 == 0) {
                Bytes other = key("device-" + random.nextInt(200));
                Bytes first = key.compareTo(other) < 0 ? key : other;
                Bytes last = first.equals(key) ? other : key;
                assertThat(all(store.range(first, last)))
                        .as("seed %d", seed)
                        .isEqualTo(all(expected.subMap(first, true, last, true)));
                assertThat(all(store.range(first, null))).isEqualTo(all(expected.tailMap(first, true)));
                assertThat(all(store.all())).isEqualTo(all(expected));
                assertThat(store.approximateNumEntries()).isEqualTo(expected.size());
            }
        }
    }

    @Test
    void whatWasReadDoesNotChangeWithTheStore() {
        store.put(key("a"), bytes("1"));
        byte[] read = store.get(key("a"));
        byte[] written = bytes("2");
        store.put(key("a"), written);
        written[0] = '3';
        assertThat(text(read)).isEqualTo("1");
        assertThat(text(store.get(key("a")))).isEqualTo("2");
    }

    @Test
    void anIteratorLeavesOutWhatWasRemovedSinceItBegan() {
        store.put(key("a"), bytes("1"));
        store.put(key("b"), bytes("2"));
        store.put(key("c"), bytes("3"));
        try (KeyValueIterator<Bytes, byte[]> each = store.all()) {
            assertThat(each.peekNextKey()).isEqualTo(key("a"));
            assertThat(each.next().key).isEqualTo(key("a"));
            store.delete(key("b"));
            store.put(key("c"), bytes("4"));
            assertThat(text(each.next().value)).isEqualTo("4");
            assertThat(each.hasNext()).isFalse();
            assertThatThrownBy(each::next).isInstanceOf(NoSuchElementException.class);
            assertThatThrownBy(each::peekNextKey).isInstanceOf(NoSuchElementException.class);
        }
    }

    @Test
    void aClosedStoreIsEmpty() {
        store.put(key("a"), bytes("1"));
        store.close();
        assertThat(store.isOpen()).isFalse();
        assertThat(store.get(key("a"))).isNull();
        assertThat(store.all().hasNext()).isFalse();
    }

    private static Bytes key(String key) {
        return Bytes.wrap(bytes(key));
    }

    private static byte[] bytes(String text) {
        return text.getBytes(StandardCharsets.UTF_8);
    }

    private static String text(byte[] bytes) {
        return bytes == null ? null : new String(bytes, StandardCharsets.UTF_8);
    }

    private static List<String> all(KeyValueIterator<Bytes, byte[]> each) {
        List<String> all = new ArrayList<>();
        each.forEachRemaining(next -> all.add(next.key + "=" + text(next.value)));
        return all;
    }

    private static List<String> all(NavigableMap<Bytes, String> expected) {
        List<String> all = new ArrayList<>();
        expected.forEach((key, value) -> all.add(key + "=" + value));
        return all;
    }
}
