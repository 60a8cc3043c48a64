package org.evoloop.fleet;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import org.evoloop.fleet.wire.Topic;
import org.evoloop.fleet.wire.Wire;

/** The records of topics, by topic and device, in order. */
public final class TopicRecords {
    private final Map<String, List<String>> records = new TreeMap<>();

    public void add(Topic topic, String device, byte[] record) {
        records.computeIfAbsent(topic + " " + device, key -> new ArrayList<>())
                .add(record == null ? "null" : Wire.text(record));
    }

    public List<String> of(Topic topic, String device) {
        return records.getOrDefault(topic + " " + device, List.of());
    }

    public List<String> of(Topic topic) {
        List<String> all = new ArrayList<>();
        records.forEach((key, list) -> {
            if (key.startsWith(topic + " ")) {
                all.addAll(list);
            }
        });
        return all;
    }

    public int size() {
        return records.values().stream().mapToInt(List::size).sum();
    }

    public Map<String, List<String>> all() {
        return records;
    }
}
