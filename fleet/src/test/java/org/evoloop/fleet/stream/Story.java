package org.evoloop.fleet.stream;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.Set;
import org.evoloop.evolution.Occurrence;
import org.evoloop.evolution.Source;
import org.evoloop.evolution.Values;
import org.evoloop.fleet.Cluster;
import org.evoloop.fleet.TopicRecords;
import org.evoloop.fleet.device.Answer;
import org.evoloop.fleet.device.Device;
import org.evoloop.fleet.device.DeviceState;
import org.evoloop.fleet.device.Model;
import org.evoloop.fleet.device.Order;
import org.evoloop.fleet.wire.Letters;
import org.evoloop.fleet.wire.Topic;
import org.evoloop.fleet.wire.Wire;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.State;

/**
 * Random records of some devices, and the expected results: those of each device's core alone in this JVM, without
 * serialization or a store.
 */
final class Story {
    static final long BEGIN = 1_000_000;
    private static final long PATIENCE_NANOS = 30_000_000_000L;

    /** A record written to a topic. */
    record Entry(Topic topic, String device, byte[] record, long atMillis) {}

    private final Random random;
    private final Model model;
    private final List<Entry> entries = new ArrayList<>();
    private final Map<String, Alone> devices = new LinkedHashMap<>();
    private final TopicRecords expected = new TopicRecords();
    private long nowMillis = BEGIN;

    private final class Alone {
        private final String id;
        private final Letters letters = new Letters();
        private final Device device;
        private long number;

        Alone(String id) {
            this.id = id;
            letters.begin(model.version(), null);
            this.device = new Device(model, PATIENCE_NANOS, letters, Wire.nanos(nowMillis));
            collect();
        }

        void collect() {
            letters.all().forEach(letter -> expected.add(letter.topic(), id, letter.text()));
            letters.begin(model.version(), device.state());
        }
    }

    Story(Model model, long seed, int devices, int steps) {
        this.model = model;
        this.random = new Random(seed);
        for (int each = 0; each < devices; each++) {
            tick(1);
            String id = "device-" + each;
            entries.add(new Entry(Topic.DEVICES, id, Wire.device(model.version()), nowMillis));
            this.devices.put(id, new Alone(id));
        }
        List<Alone> all = List.copyOf(this.devices.values());
        for (int step = 0; step < steps * devices; step++) {
            // Each device has a record every few seconds, and sometimes a long pause.
            tick(devices > 1_000 ? 1 : 1 + random.nextInt(random.nextInt(10) == 0 ? 200 : 20));
            happen(all.get(random.nextInt(devices)));
        }
    }

    private void tick(long millis) {
        nowMillis += millis;
    }

    private void happen(Alone alone) {
        DeviceState state = alone.device.state();
        if (state.open() != null && random.nextInt(4) > 0) {
            Answer answer = answer(state);
            entries.add(new Entry(Topic.EFFECTS, alone.id, Wire.effect(answer), nowMillis));
            alone.device.answered(answer);
        } else {
            Occurrence occurrence = occurrence(state);
            // Sometimes a gateway repeats a record.
            long number = random.nextInt(8) == 0 ? alone.number : ++alone.number;
            entries.add(new Entry(Topic.OCCURRENCES, alone.id, Wire.occurrence(occurrence, number), nowMillis));
            if (alone.device.isNews(number)) {
                alone.device.observed(occurrence);
            }
        }
        alone.collect();
    }

    private Answer answer(DeviceState state) {
        int dice = random.nextInt(100);
        Answer.Outcome outcome =
                dice < 85 ? Answer.Outcome.SENT : dice < 93 ? Answer.Outcome.FAILED : Answer.Outcome.IN_DOUBT;
        State found = state.open().kind() == Order.Kind.LOCATE ? deviceState() : null;
        // Some answers are for an order that was already given up.
        long sequence = random.nextInt(12) == 0 && state.lost() != null
                ? state.lost().sequence()
                : state.open().sequence();
        return new Answer(sequence, outcome, outcome == Answer.Outcome.SENT ? "" : "why", found, nanos());
    }

    private Occurrence occurrence(DeviceState state) {
        int dice = random.nextInt(100);
        if (dice < 4) {
            return new Occurrence.Found(deviceState(), nanos());
        } else if (dice < 6) {
            return heard("nobodyKnowsThis", false, 0);
        } else if (dice < 14) {
            return heard("switch", true, 0);
        } else if (dice < 16) {
            return heard("switch", false, state.snapshot().visit().number());
        }
        return heard("switch", false, 0);
    }

    private Occurrence heard(String event, boolean acted, long visit) {
        return new Occurrence.Heard(
                new Event(event), Values.of("step", nowMillis), Source.PANEL, acted, Set.of(), visit, nanos());
    }

    private State deviceState() {
        List<State> states =
                List.copyOf(model.rules().table().models().original().states());
        return states.get(random.nextInt(states.size()));
    }

    private long nanos() {
        return Wire.nanos(nowMillis);
    }

    List<Entry> entries() {
        return entries;
    }

    /** The expected records, with everything due by the time of the last record of each device's partition. */
    TopicRecords recordsAt(Cluster cluster) {
        Map<Integer, Long> last = new LinkedHashMap<>();
        entries.forEach(entry -> last.merge(cluster.partitionOf(entry.device), entry.atMillis, Math::max));
        devices.forEach((id, alone) -> {
            alone.device.due(Wire.nanos(last.get(cluster.partitionOf(id))));
            alone.collect();
        });
        return expected;
    }
}
