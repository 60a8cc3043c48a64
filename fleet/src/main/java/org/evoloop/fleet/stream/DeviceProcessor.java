package org.evoloop.fleet.stream;

import java.time.Duration;
import java.util.Map;
import org.apache.kafka.streams.KeyValue;
import org.apache.kafka.streams.processor.PunctuationType;
import org.apache.kafka.streams.processor.api.Processor;
import org.apache.kafka.streams.processor.api.ProcessorContext;
import org.apache.kafka.streams.processor.api.Record;
import org.apache.kafka.streams.processor.api.RecordMetadata;
import org.apache.kafka.streams.state.KeyValueIterator;
import org.apache.kafka.streams.state.KeyValueStore;
import org.evoloop.core.text.SnapshotException;
import org.evoloop.evolution.Occurrence;
import org.evoloop.fleet.device.Answer;
import org.evoloop.fleet.device.Device;
import org.evoloop.fleet.device.Kept;
import org.evoloop.fleet.device.KeptText;
import org.evoloop.fleet.device.Model;
import org.evoloop.fleet.wire.Letters;
import org.evoloop.fleet.wire.Reading;
import org.evoloop.fleet.wire.Refusal;
import org.evoloop.fleet.wire.Topic;
import org.evoloop.fleet.wire.Wire;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** Tells the devices of one partition what comes for them and what is due, and keeps what they know in a store. */
final class DeviceProcessor implements Processor<String, byte[], String, byte[]> {
    static final String STORE = "devices";
    static final String MODELS = "models";
    static final String ROLLOUTS = "rollouts";

    private static final Logger LOG = LoggerFactory.getLogger(DeviceProcessor.class);
    private static final Duration TICK = Duration.ofMillis(50);
    private static final Duration LOOK = Duration.ofMillis(500);

    private static final long CATCH_UP_MILLIS = 1_000;

    /** So many devices are looked at in one go, so that records do not wait for all of them. */
    private static final int SLICE = 2_000;

    private final FleetSettings settings;
    private final Map<String, Topic> topics;
    private final long patienceNanos;
    private final Schedule schedule = new Schedule();
    private final Recent recent = new Recent();
    private ProcessorContext<String, byte[]> context;
    private KeyValueStore<String, byte[]> store;
    private Library library;
    private Rollouts rollouts;
    private Letters letters;

    /** When the last record was written, and when it was taken. */
    private long writtenMillis;

    private long takenMillis;

    /** Where the sweep for a rollout goes on; null if there is none. */
    private @Nullable String sweep;

    @SuppressWarnings("NullAway.Init") // init comes before all else
    DeviceProcessor(FleetSettings settings, Map<String, Topic> topics) {
        this.settings = settings;
        this.topics = topics;
        this.patienceNanos = settings.patience().toNanos();
    }

    @Override
    public void init(ProcessorContext<String, byte[]> given) {
        context = given;
        store = given.getStateStore(STORE);
        library = new Library(given.getStateStore(MODELS));
        rollouts = new Rollouts(given.getStateStore(ROLLOUTS), library);
        letters = new Letters();
        // After a failure the same object may begin again with another store.
        schedule.clear();
        recent.clear();
        sweep = "";
        writtenMillis = 0;
        takenMillis = given.currentSystemTimeMs();
        reschedule();
        if (settings.isWallClock()) {
            given.schedule(TICK, PunctuationType.WALL_CLOCK_TIME, this::tick);
        } else {
            given.schedule(Duration.ofMillis(1), PunctuationType.STREAM_TIME, this::tick);
        }
        given.schedule(LOOK, PunctuationType.WALL_CLOCK_TIME, now -> look());
    }

    /** What is due is not kept by itself: the snapshots tell. */
    private void reschedule() {
        try (KeyValueIterator<String, byte[]> each = store.all()) {
            while (each.hasNext()) {
                KeyValue<String, byte[]> next = each.next();
                try {
                    Model model = library.model(KeptText.model(next.value));
                    schedule(next.key, KeptText.read(model.rules(), next.value));
                } catch (Refusal | SnapshotException | IllegalArgumentException e) {
                    LOG.error("nothing will be due at the device {}: {}", next.key, e.getMessage());
                }
            }
        }
    }

    // What comes in

    @Override
    public void process(Record<String, byte[]> record) {
        RecordMetadata from = context.recordMetadata().orElseThrow();
        writtenMillis = record.timestamp();
        takenMillis = context.currentSystemTimeMs();
        try {
            if (record.key() == null || record.key().isEmpty()) {
                throw new Refusal(Refusal.Reason.MALFORMED, "it has no key; the key is the device's id");
            }
            take(topics.get(from.topic()), record);
        } catch (Refusal refusal) {
            refuse(record, from, refusal);
        } catch (RuntimeException defect) {
            LOG.error("a record for {} was not taken; this is a defect", record.key(), defect);
            refuse(record, from, new Refusal(Refusal.Reason.DEFECT, defect.toString()));
        }
    }

    private void refuse(Record<String, byte[]> record, RecordMetadata from, Refusal refusal) {
        letters.begin("", null);
        letters.add(
                Topic.DEAD_LETTERS,
                Wire.deadLetter(refusal, from.topic(), from.partition(), from.offset(), record.value()));
        send(record.key(), record.timestamp());
    }

    private void take(@Nullable Topic topic, Record<String, byte[]> record) {
        String id = record.key();
        if (topic == Topic.DEVICES) {
            register(id, record);
            return;
        }
        Reading reading = Reading.of(record.value());
        Kept before = known(id);
        if (before == null) {
            throw new Refusal(
                    Refusal.Reason.UNKNOWN_DEVICE,
                    "no device " + id + " was registered; write it to " + topicOfDevices());
        }
        if (topic == Topic.EFFECTS) {
            Answer answer = reading.answer();
            requireLikely(answer.atNanos());
            Device device = device(before);
            device.answered(answer);
            keep(id, before, device, record.timestamp());
        } else {
            Occurrence occurrence = reading.occurrence();
            long number = reading.number("number", 0);
            requireLikely(occurrence.observedNanos());
            Device device = device(before);
            if (device.isNews(number)) {
                device.observed(occurrence);
                keep(id, before, device, record.timestamp());
            }
        }
    }

    private String topicOfDevices() {
        return Topic.DEVICES.of(settings.fleet());
    }

    private void register(String id, Record<String, byte[]> record) {
        if (record.value() == null) {
            store.delete(id);
            recent.remove(id);
            schedule.set(id, Device.NEVER);
            context.forward(new Record<>(id, null, record.timestamp()), Topic.STATES.name());
            return;
        }
        String version = Reading.of(record.value()).text("model");
        Kept known = known(id);
        if (known == null) {
            Model model = library.model(version);
            letters.begin(version, null);
            long since = Math.min(record.timestamp(), now());
            keep(id, null, new Device(model, patienceNanos, letters, Wire.nanos(since)), record.timestamp());
        } else if (!known.model().equals(version)) {
            throw new Refusal(
                    Refusal.Reason.REGISTERED_ALREADY,
                    "the device " + id + " has the models " + known.model() + "; a rollout gives it others");
        }
    }

    private long now() {
        return settings.isWallClock() ? context.currentSystemTimeMs() : context.currentStreamTimeMs();
    }

    /** A clock that is ahead would have timers fire early from then on. */
    private void requireLikely(long atNanos) {
        long ahead = Wire.millis(atNanos) - now();
        if (ahead > settings.clockAhead().toMillis()) {
            throw new Refusal(Refusal.Reason.CLOCK, "it is " + ahead + " ms ahead of this machine's clock");
        } else if (-ahead > settings.clockBehind().toMillis()) {
            throw new Refusal(Refusal.Reason.CLOCK, "it is " + -ahead + " ms behind this machine's clock");
        }
    }

    // Devices

    private @Nullable Kept known(String id) {
        Kept kept = recent.get(id);
        if (kept == null) {
            byte[] bytes = store.get(id);
            if (bytes == null) {
                return null;
            }
            kept = open(bytes);
            recent.put(id, kept);
        }
        return kept;
    }

    private Kept open(byte[] bytes) {
        try {
            return KeptText.read(library.model(KeptText.model(bytes)).rules(), bytes);
        } catch (SnapshotException | IllegalArgumentException e) {
            throw new Refusal(Refusal.Reason.UNUSABLE_STATE, "what is kept of the device: " + e.getMessage());
        }
    }

    private Device device(Kept kept) {
        letters.begin(kept.model(), kept);
        return new Device(library.model(kept.model()), kept, patienceNanos, letters);
    }

    private void keep(String id, @Nullable Kept before, Device device, long timestamp) {
        evolve(id, device, timestamp);
        Kept kept = device.kept();
        if (!kept.equals(before)) {
            store.put(id, KeptText.write(kept));
            recent.put(id, kept);
        }
        for (String rollout : rollouts.watching(id, kept.model())) {
            if (letters.good() + letters.bad() > 0) {
                byte[] verdict = RolloutWatch.verdict(letters.good(), letters.bad());
                context.forward(new Record<>(rollout, verdict, timestamp), Topic.VERDICTS.name());
            }
        }
        send(id, timestamp);
        schedule(id, kept);
    }

    /** What is overdue already waits a little for what the device has told before and is still on its way. */
    private void schedule(String id, Kept kept) {
        long due = Device.dueNanos(kept, patienceNanos);
        long soonest = Wire.nanos(now() + CATCH_UP_MILLIS);
        boolean overdue = settings.isWallClock() && due < soonest - Wire.nanos(CATCH_UP_MILLIS);
        schedule.set(id, overdue ? soonest : due);
    }

    private void send(String id, long timestamp) {
        for (Letters.Letter letter : letters.all()) {
            context.forward(
                    new Record<>(id, letter.text(), timestamp), letter.topic().name());
        }
    }

    private void evolve(String id, Device device, long timestamp) {
        Model.Takeover takeover = rollouts.isEmpty() ? null : rollouts.of(id, device.model());
        if (takeover != null) {
            String before = device.model();
            letters.becomes(takeover.next().version());
            if (!device.evolve(takeover, Wire.nanos(Math.min(timestamp, now()))).isEmpty()) {
                letters.becomes(before);
            }
        }
    }

    // What is due

    private void tick(long nowMillis) {
        if (settings.isWallClock() && isBehind(nowMillis)) {
            return;
        }
        long now = Wire.nanos(nowMillis);
        for (int looked = 0; looked < SLICE; looked++) {
            String id = schedule.poll(now);
            if (id == null) {
                break;
            }
            lookAt(id, now, nowMillis);
        }
        sweep(now, nowMillis);
    }

    private void lookAt(String id, long now, long timestamp) {
        try {
            Kept before = known(id);
            if (before == null) {
                return;
            }
            Device device = device(before);
            device.due(now, settings.isWallClock());
            keep(id, before, device, timestamp);
        } catch (RuntimeException defect) {
            LOG.error("what is due at {} is left out; this is a defect", id, defect);
        }
    }

    /** Whether records are being taken that have been lying there: what they tell may have happened before what is due. */
    private boolean isBehind(long nowMillis) {
        return nowMillis - writtenMillis > CATCH_UP_MILLIS && nowMillis - takenMillis < CATCH_UP_MILLIS;
    }

    private void look() {
        if (rollouts.refresh()) {
            sweep = "";
        }
    }

    /** Idle devices are told nothing, and take part in rollouts all the same. */
    private void sweep(long now, long timestamp) {
        if (sweep == null || rollouts.isEmpty()) {
            return;
        }
        String last = null;
        int looked = 0;
        try (KeyValueIterator<String, byte[]> each = store.range(sweep.isEmpty() ? null : sweep, null)) {
            while (each.hasNext() && looked < SLICE) {
                KeyValue<String, byte[]> next = each.next();
                last = next.key;
                looked++;
                if (rollouts.of(next.key, KeptText.model(next.value)) != null) {
                    lookAt(next.key, now, timestamp);
                }
            }
        }
        sweep = looked < SLICE || last == null ? null : last + '\0';
    }
}
