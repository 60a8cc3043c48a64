package org.evoloop.fleet.stream;

import java.time.Duration;
import java.util.Map;
import org.apache.kafka.streams.processor.PunctuationType;
import org.apache.kafka.streams.processor.api.Processor;
import org.apache.kafka.streams.processor.api.ProcessorContext;
import org.apache.kafka.streams.processor.api.Record;
import org.apache.kafka.streams.processor.api.RecordMetadata;
import org.evoloop.evolution.Occurrence;
import org.evoloop.fleet.device.Answer;
import org.evoloop.fleet.device.Device;
import org.evoloop.fleet.device.DeviceState;
import org.evoloop.fleet.device.Model;
import org.evoloop.fleet.wire.Letters;
import org.evoloop.fleet.wire.Reading;
import org.evoloop.fleet.wire.Refusal;
import org.evoloop.fleet.wire.Topic;
import org.evoloop.fleet.wire.Wire;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** Passes incoming records and due timers to the devices of one partition, and sends their results. */
final class DeviceProcessor implements Processor<String, byte[], String, byte[]> {
    static final String STORE = "devices";
    static final String MODELS = "models";
    static final String ROLLOUTS = "rollouts";

    private static final Logger LOG = LoggerFactory.getLogger(DeviceProcessor.class);
    private static final Duration TICK = Duration.ofMillis(50);
    private static final Duration LOOK = Duration.ofMillis(500);

    /** The most devices handled in one go, so that records need not wait for all of them. */
    private static final int SLICE = 2_000;

    private static final int LONGEST_ID = 1_000;

    private final FleetSettings settings;
    private final Map<String, Topic> topics;
    private final FleetCounts counts;
    private final long patienceNanos;
    private final Letters letters = new Letters();
    private ProcessorContext<String, byte[]> context;
    private Clock clock;
    private Library library;
    private Devices devices;
    private Agenda agenda;
    private Rollouts rollouts;

    /** Becomes the device of each record in turn; null until the first. */
    private @Nullable Device device;

    /** Whether idle devices are being visited for a rollout, and the next of them; null for the first. */
    private boolean sweeping;

    private @Nullable String sweptTo;

    @SuppressWarnings("NullAway.Init") // init comes before all else
    DeviceProcessor(FleetSettings settings, Map<String, Topic> topics, FleetCounts counts) {
        this.settings = settings;
        this.topics = topics;
        this.counts = counts;
        this.patienceNanos = settings.patience().toNanos();
    }

    /** After a failure the same object may be initialised again with another store. */
    @Override
    public void init(ProcessorContext<String, byte[]> given) {
        context = given;
        clock = new Clock(given, settings);
        library = new Library(given.getStateStore(MODELS));
        devices = new Devices(given.getStateStore(STORE), library);
        rollouts = new Rollouts(given.getStateStore(ROLLOUTS), library);
        agenda = new Agenda(clock);
        beginSweep();
        // The agenda is not stored; it is rebuilt from the devices' states.
        devices.eachDue(patienceNanos, agenda::set);
        if (clock.isWall()) {
            given.schedule(TICK, PunctuationType.WALL_CLOCK_TIME, this::tick);
        } else {
            given.schedule(Duration.ofMillis(1), PunctuationType.STREAM_TIME, this::tick);
        }
        given.schedule(LOOK, PunctuationType.WALL_CLOCK_TIME, now -> look());
    }

    // Incoming records

    @Override
    public void process(Record<String, byte[]> record) {
        RecordMetadata from = context.recordMetadata().orElseThrow();
        agenda.takes(record.timestamp());
        try {
            if (record.key() == null || record.key().isEmpty()) {
                throw new Refusal(Refusal.Reason.MALFORMED, "it has no key; the key is the device's id");
            } else if (record.key().length() > LONGEST_ID) {
                throw new Refusal(
                        Refusal.Reason.MALFORMED,
                        "its key has " + record.key().length() + " characters, allowed are " + LONGEST_ID);
            }
            take(topics.get(from.topic()), record);
        } catch (Refusal refusal) {
            refuse(record, from, refusal);
        } catch (RuntimeException defect) {
            LOG.error("a record for {} could not be processed; this is a defect", record.key(), defect);
            refuse(record, from, new Refusal(Refusal.Reason.DEFECT, defect.toString()));
        }
    }

    private void refuse(Record<String, byte[]> record, RecordMetadata from, Refusal refusal) {
        counts.refused(refusal.reason());
        letters.begin("", null);
        letters.add(
                Topic.DEAD_LETTERS,
                Wire.deadLetter(refusal, from.topic(), from.partition(), from.offset(), record.value()));
        String key = record.key();
        send(key == null ? null : Wire.cut(key, LONGEST_ID), record.timestamp());
    }

    private void take(@Nullable Topic topic, Record<String, byte[]> record) {
        String id = record.key();
        if (topic == Topic.DEVICES) {
            register(id, record);
            return;
        }
        Reading reading = Reading.of(record.value());
        DeviceState before = devices.get(id);
        if (before == null) {
            throw new Refusal(
                    Refusal.Reason.UNKNOWN_DEVICE,
                    "no device " + id + " was registered; write it to " + Topic.DEVICES.of(settings.fleet()));
        }
        if (topic == Topic.EFFECTS) {
            Answer answer = reading.answer();
            clock.requireLikely(answer.atNanos());
            Device device = device(before);
            device.answered(answer);
            store(id, before, device, record.timestamp());
        } else {
            Occurrence occurrence = reading.occurrence();
            long number = reading.record().number("number", 0);
            clock.requireLikely(occurrence.observedNanos());
            Device device = device(before);
            if (device.isNews(number)) {
                device.observed(occurrence);
                store(id, before, device, record.timestamp());
            }
        }
    }

    private void register(String id, Record<String, byte[]> record) {
        if (record.value() == null) {
            devices.remove(id);
            agenda.set(id, Device.NEVER);
            context.forward(new Record<>(id, null, record.timestamp()), Topic.STATES.name());
            return;
        }
        String version = Reading.of(record.value()).name("model");
        DeviceState known = devices.get(id);
        if (known == null) {
            Model model = library.model(version);
            letters.begin(version, null);
            Device device =
                    new Device(model, devices.past(id), patienceNanos, letters, clock.atMost(record.timestamp()));
            store(id, null, device, record.timestamp());
        } else if (!known.model().equals(version)) {
            throw new Refusal(
                    Refusal.Reason.REGISTERED_ALREADY,
                    "the device " + id + " has the models " + known.model() + "; use a rollout to change them");
        }
    }

    private Device device(DeviceState state) {
        letters.begin(state.model(), state);
        Model model = library.model(state.model());
        Device known = device;
        if (known == null) {
            known = new Device(model, state, patienceNanos, letters);
            device = known;
        } else {
            known.become(model, state);
        }
        return known;
    }

    // Results

    private void store(String id, @Nullable DeviceState before, Device device, long timestamp) {
        evolve(id, device, timestamp);
        letters.all().forEach(letter -> Wire.requireSendable(letter.text(), "a record in " + letter.topic()));
        counts.results(letters.good(), letters.bad());
        DeviceState state = device.state();
        if (!state.equals(before)) {
            devices.put(id, state);
        }
        for (String rollout : rollouts.watching(id, state.model())) {
            if (letters.good() + letters.bad() > 0) {
                byte[] verdict = RolloutWatch.verdict(letters.good(), letters.bad());
                context.forward(new Record<>(rollout, verdict, timestamp), Topic.VERDICTS.name());
            }
        }
        send(id, timestamp);
        // With many devices, looking for an entry takes as long as deciding, so not if there can be none.
        if (Device.mayBeDue(state) || (before != null && Device.mayBeDue(before))) {
            agenda.set(id, device.dueNanos());
        }
    }

    private void send(@Nullable String id, long timestamp) {
        for (Letters.Letter letter : letters.all()) {
            context.forward(
                    new Record<>(id, letter.text(), timestamp), letter.topic().name());
        }
    }

    private void evolve(String id, Device device, long timestamp) {
        Model.Takeover takeover = rollouts.of(id, device.model());
        if (takeover != null) {
            String before = device.model();
            letters.becomes(takeover.next().version());
            if (!device.evolve(takeover, clock.atMost(timestamp)).isEmpty()) {
                letters.becomes(before);
            }
        }
    }

    // Due timers, and rollouts

    private void tick(long nowMillis) {
        for (int looked = 0; looked < SLICE; looked++) {
            String id = agenda.poll(nowMillis);
            if (id == null) {
                break;
            }
            lookAt(id, nowMillis);
        }
        if (!agenda.isBehind(nowMillis)) {
            sweep(nowMillis);
        }
    }

    private void lookAt(String id, long nowMillis) {
        try {
            DeviceState before = devices.get(id);
            if (before == null) {
                return;
            }
            Device device = device(before);
            device.due(Wire.nanos(nowMillis), clock.isWall());
            store(id, before, device, nowMillis);
        } catch (RuntimeException defect) {
            LOG.error("a due timer or command of {} could not be handled; this is a defect", id, defect);
        }
    }

    private void look() {
        if (rollouts.refresh()) {
            beginSweep();
        }
    }

    private void beginSweep() {
        sweeping = true;
        sweptTo = null;
    }

    /** Rollouts include idle devices, which receive no records. */
    private void sweep(long nowMillis) {
        if (sweeping && !rollouts.isEmpty()) {
            sweptTo = devices.walk(
                    sweptTo, SLICE, (id, version) -> rollouts.of(id, version) != null, id -> lookAt(id, nowMillis));
            sweeping = sweptTo != null;
        }
    }
}
