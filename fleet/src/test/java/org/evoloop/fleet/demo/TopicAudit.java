package org.evoloop.fleet.demo;

import java.time.Duration;
import java.util.ArrayList;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.StringJoiner;
import java.util.TreeMap;
import java.util.TreeSet;
import org.apache.kafka.clients.consumer.ConsumerConfig;
import org.apache.kafka.clients.consumer.ConsumerRecord;
import org.apache.kafka.clients.consumer.KafkaConsumer;
import org.apache.kafka.common.PartitionInfo;
import org.apache.kafka.common.TopicPartition;
import org.apache.kafka.common.serialization.ByteArrayDeserializer;
import org.apache.kafka.common.serialization.StringDeserializer;
import org.evoloop.fleet.wire.Reading;
import org.evoloop.fleet.wire.Topic;
import org.evoloop.payload.JsonRecord;
import org.jspecify.annotations.Nullable;

/**
 * What a fleet's topics contain, read afresh from their beginnings. Tells whether a wrong count comes from the input, the
 * fleet or the counting: each press has its device and time, each command and answer its device and sequence number.
 */
final class TopicAudit {
    private static final Duration LIMIT = Duration.ofMinutes(1);
    private static final int SHOWN = 50;

    /** By topic, and by what identifies a record: the places where it is. */
    private final Map<Topic, Map<String, List<String>>> records = new EnumMap<>(Topic.class);

    private TopicAudit() {}

    static TopicAudit of(String bootstrap, String fleet) {
        TopicAudit audit = new TopicAudit();
        try (KafkaConsumer<String, byte[]> consumer = new KafkaConsumer<>(
                Map.of(
                        ConsumerConfig.BOOTSTRAP_SERVERS_CONFIG,
                        bootstrap,
                        ConsumerConfig.ISOLATION_LEVEL_CONFIG,
                        "read_committed"),
                new StringDeserializer(),
                new ByteArrayDeserializer())) {
            for (Topic topic : List.of(Topic.OCCURRENCES, Topic.EFFECTS, Topic.DECISIONS, Topic.COMMANDS)) {
                audit.read(consumer, topic, fleet);
            }
        }
        return audit;
    }

    private void read(KafkaConsumer<String, byte[]> consumer, Topic topic, String fleet) {
        List<TopicPartition> partitions = new ArrayList<>();
        for (PartitionInfo each : consumer.partitionsFor(topic.of(fleet))) {
            partitions.add(new TopicPartition(each.topic(), each.partition()));
        }
        consumer.assign(partitions);
        consumer.seekToBeginning(partitions);
        Map<TopicPartition, Long> ends = consumer.endOffsets(partitions);
        Map<String, List<String>> places = new TreeMap<>();
        records.put(topic, places);
        long begun = System.nanoTime();
        while (ends.entrySet().stream().anyMatch(end -> consumer.position(end.getKey()) < end.getValue())
                && System.nanoTime() - begun < LIMIT.toNanos()) {
            for (ConsumerRecord<String, byte[]> record : consumer.poll(Duration.ofMillis(200))) {
                JsonRecord reading = Reading.of(record.value()).record();
                String identity = identity(topic, reading);
                if (identity != null) {
                    String place = record.partition() + "/" + record.offset() + " " + reading.text("outcome", "");
                    places.computeIfAbsent(record.key() + " " + identity, key -> new ArrayList<>())
                            .add(place.strip());
                }
            }
        }
    }

    /** Null if the record is not about an occurrence or command. */
    private static @Nullable String identity(Topic topic, JsonRecord reading) {
        return switch (topic) {
            case OCCURRENCES -> press(reading, reading.text("event", ""));
            case DECISIONS -> press(reading, reading.text("occurrence", ""));
            default -> "sequence " + reading.number("sequence");
        };
    }

    private static @Nullable String press(JsonRecord reading, String event) {
        return event.equals("switch") ? "press at " + reading.number("atMillis") : null;
    }

    /** Records that are missing, duplicated, or belong to no press or command. */
    List<String> problems() {
        List<String> problems = new ArrayList<>();
        records.forEach((topic, places) -> places.forEach((identity, at) -> {
            if (at.size() > 1) {
                problems.add(topic + " more than once: " + identity + " at " + at);
            }
        }));
        missing(Topic.OCCURRENCES, Topic.DECISIONS).forEach(each -> problems.add("pressed, not decided: " + each));
        missing(Topic.DECISIONS, Topic.OCCURRENCES).forEach(each -> problems.add("decided, not pressed: " + each));
        missing(Topic.EFFECTS, Topic.COMMANDS).forEach(each -> problems.add("answered, not commanded: " + each));
        return problems;
    }

    private Set<String> missing(Topic from, Topic in) {
        Set<String> missing = new TreeSet<>(places(from).keySet());
        missing.removeAll(places(in).keySet());
        return missing;
    }

    private Map<String, List<String>> places(Topic topic) {
        return records.getOrDefault(topic, Map.of());
    }

    /** For each topic the number of records and of presses or commands, and the first problems. */
    @Override
    public String toString() {
        StringJoiner text = new StringJoiner("\n");
        records.forEach((topic, places) -> text.add(
                topic + ": " + places.values().stream().mapToInt(List::size).sum() + " records of " + places.size()));
        problems().stream().limit(SHOWN).forEach(text::add);
        return text.toString();
    }
}
