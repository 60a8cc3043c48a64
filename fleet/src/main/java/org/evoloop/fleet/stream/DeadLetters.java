package org.evoloop.fleet.stream;

import java.time.Duration;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.function.BiConsumer;
import org.apache.kafka.clients.consumer.ConsumerConfig;
import org.apache.kafka.clients.consumer.ConsumerRecord;
import org.apache.kafka.clients.consumer.KafkaConsumer;
import org.apache.kafka.clients.producer.KafkaProducer;
import org.apache.kafka.clients.producer.ProducerConfig;
import org.apache.kafka.clients.producer.ProducerRecord;
import org.apache.kafka.common.KafkaException;
import org.apache.kafka.common.TopicPartition;
import org.apache.kafka.common.errors.ProducerFencedException;
import org.evoloop.fleet.wire.DeadLetter;
import org.evoloop.fleet.wire.Reading;
import org.evoloop.fleet.wire.Refusal;
import org.evoloop.fleet.wire.Resent;
import org.evoloop.fleet.wire.Topic;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * The dead letters of a fleet, and sending them again. Marks in the same topic tell which letters were sent again, so
 * that each is sent once, whichever process ends in between.
 *
 * <p>Threading: not thread-safe.
 *
 * @since 0.1
 */
public final class DeadLetters {
    private static final Logger LOG = LoggerFactory.getLogger(DeadLetters.class);
    private static final Duration POLL = Duration.ofMillis(200);

    /** The letters sent in one transaction, so that it ends well before the broker's limit. */
    private static final int BATCH = 200;

    private final KafkaCluster cluster;
    private final String fleet;
    private final TopicPartition letters;

    /** The dead letters of {@code fleet}. */
    public DeadLetters(KafkaCluster cluster, String fleet) {
        this.cluster = cluster;
        this.fleet = fleet;
        this.letters = new TopicPartition(Topic.DEAD_LETTERS.of(fleet), 0);
    }

    /** What became of letters. */
    public static final class Counts {
        private final Map<String, Long> sent = new TreeMap<>();
        private long cut;

        /** The letters sent again, by reason. */
        public Map<String, Long> sent() {
            return sent;
        }

        /** The letters that could not be sent again, because the fleet kept only the beginning of these records. */
        public long cut() {
            return cut;
        }
    }

    /**
     * Passes each letter of these reasons that was not sent again yet to {@code reader}, with the id of its device, null if
     * it has none.
     *
     * @throws FleetException if the letters cannot be read
     */
    public void eachUnsent(Set<String> reasons, BiConsumer<@Nullable String, DeadLetter> reader) {
        try {
            Map<String, Long> marks = marks();
            readAll(record -> {
                DeadLetter letter = unsent(record, reasons, marks);
                if (letter != null) {
                    reader.accept(record.key(), letter);
                }
            });
        } catch (KafkaException e) {
            throw failed(e);
        }
    }

    /**
     * Sends each letter of these reasons again that was not sent again yet. One that still cannot be processed comes back
     * as a new letter.
     *
     * @throws FleetException if they cannot be read or written, or another process does the same; what was written by
     *     then is marked
     */
    public Counts sendAgain(Set<String> reasons) {
        Counts counts = new Counts();
        try (KafkaProducer<String, byte[]> producer =
                cluster.producer(Map.of(ProducerConfig.TRANSACTIONAL_ID_CONFIG, fleet + "-resend"))) {
            // From here on, no other process that did the same can write; so its marks are complete.
            producer.initTransactions();
            Map<String, Long> marks = marks();
            Batch batch = new Batch(producer);
            readAll(record -> {
                DeadLetter letter = unsent(record, reasons, marks);
                if (letter != null) {
                    batch.add(record, letter, counts);
                }
            });
            batch.commit();
        } catch (KafkaException e) {
            throw failed(e);
        }
        return counts;
    }

    /** Letters that are sent and marked together, or not at all. */
    private final class Batch {
        private final KafkaProducer<String, byte[]> producer;
        private final Map<String, Long> marks = new TreeMap<>();
        private int size;

        Batch(KafkaProducer<String, byte[]> producer) {
            this.producer = producer;
        }

        void add(ConsumerRecord<String, byte[]> record, DeadLetter letter, Counts counts) {
            if (!letter.isWhole()) {
                counts.cut++;
                return;
            }
            if (size++ == 0) {
                producer.beginTransaction();
            }
            write(new ProducerRecord<>(letter.topic(), record.key(), letter.record()));
            marks.put(letter.reason(), record.offset() + 1);
            counts.sent.merge(letter.reason(), 1L, Long::sum);
            if (size == BATCH) {
                commit();
            }
        }

        void commit() {
            if (size > 0) {
                marks.forEach((reason, before) ->
                        write(new ProducerRecord<>(letters.topic(), 0, null, new Resent(reason, before).bytes())));
                producer.commitTransaction();
                marks.clear();
                size = 0;
            }
        }

        private void write(ProducerRecord<String, byte[]> record) {
            // A failure is thrown when the transaction is committed.
            LOG.trace("sending {}", producer.send(record));
        }
    }

    /** The letter in {@code record}; null if it is not to be sent. */
    private @Nullable DeadLetter unsent(
            ConsumerRecord<String, byte[]> record, Set<String> reasons, Map<String, Long> marks) {
        try {
            return Reading.of(record.value())
                    .deadLetter()
                    .filter(letter -> reasons.contains(letter.reason()))
                    .filter(letter -> record.offset() >= marks.getOrDefault(letter.reason(), 0L))
                    .filter(letter -> isIncoming(letter.topic()))
                    .orElse(null);
        } catch (Refusal foreign) {
            LOG.warn("the record {} of {} is ignored: {}", record.offset(), letters.topic(), foreign.detail());
            return null;
        }
    }

    /** Whether the fleet reads this topic. */
    private boolean isIncoming(String topic) {
        return List.of(Topic.DEVICES, Topic.OCCURRENCES, Topic.EFFECTS).stream()
                .anyMatch(each -> each.of(fleet).equals(topic));
    }

    /** By reason, the offset before which the letters have been sent again. */
    private Map<String, Long> marks() {
        Map<String, Long> marks = new HashMap<>();
        readAll(record -> {
            try {
                Reading.of(record.value())
                        .resent()
                        .ifPresent(mark -> marks.merge(mark.reason(), mark.before(), Math::max));
            } catch (Refusal foreign) {
                LOG.debug("a record that the fleet did not write", foreign);
            }
        });
        return marks;
    }

    private interface Reader {
        void read(ConsumerRecord<String, byte[]> record);
    }

    private void readAll(Reader reader) {
        try (KafkaConsumer<String, byte[]> consumer =
                cluster.consumer(Map.of(ConsumerConfig.ISOLATION_LEVEL_CONFIG, "read_committed"))) {
            consumer.assign(List.of(letters));
            consumer.seekToBeginning(List.of(letters));
            long end = consumer.endOffsets(List.of(letters)).getOrDefault(letters, 0L);
            while (consumer.position(letters) < end) {
                for (ConsumerRecord<String, byte[]> record : consumer.poll(POLL)) {
                    if (record.offset() < end) {
                        reader.read(record);
                    }
                }
            }
        }
    }

    private FleetException failed(KafkaException failure) {
        if (failure instanceof ProducerFencedException) {
            return new FleetException("another process sends the dead letters of the fleet '" + fleet + "' again");
        }
        return new FleetException(
                "the dead letters of the fleet '" + fleet + "' cannot be sent again: " + failure.getMessage());
    }
}
