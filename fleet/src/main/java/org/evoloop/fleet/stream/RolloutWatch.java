package org.evoloop.fleet.stream;

import java.nio.ByteBuffer;
import java.time.Duration;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import org.apache.kafka.streams.processor.PunctuationType;
import org.apache.kafka.streams.processor.api.Processor;
import org.apache.kafka.streams.processor.api.ProcessorContext;
import org.apache.kafka.streams.processor.api.Record;
import org.apache.kafka.streams.state.KeyValueIterator;
import org.apache.kafka.streams.state.KeyValueStore;
import org.evoloop.fleet.wire.Refusal;
import org.evoloop.fleet.wire.Rollout;
import org.evoloop.fleet.wire.Topic;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** Counts the results of devices that have the models of a rollout, and stops a rollout with too many failures. */
final class RolloutWatch implements Processor<String, byte[], String, byte[]> {
    static final String STORE = "rollout-tallies";

    private static final Logger LOG = LoggerFactory.getLogger(RolloutWatch.class);

    private static final Duration LOOK = Duration.ofMillis(500);

    /** The records of the rollouts stopped already, although the global copy may not show it yet. */
    private final Map<String, byte[]> stopped = new HashMap<>();

    private ProcessorContext<String, byte[]> context;
    private KeyValueStore<String, byte[]> tallies;
    private KeyValueStore<String, byte[]> rollouts;

    @SuppressWarnings("NullAway.Init") // init comes before all else
    RolloutWatch() {}

    static byte[] verdict(long good, long bad) {
        return ByteBuffer.allocate(2 * Long.BYTES).putLong(good).putLong(bad).array();
    }

    @Override
    public void init(ProcessorContext<String, byte[]> given) {
        context = given;
        stopped.clear();
        tallies = given.getStateStore(STORE);
        rollouts = given.getStateStore(DeviceProcessor.ROLLOUTS);
        given.schedule(LOOK, PunctuationType.WALL_CLOCK_TIME, now -> forget());
    }

    /** What was counted for steps that are over must not count if the same step is taken again. */
    private void forget() {
        stopped.entrySet().removeIf(each -> !Arrays.equals(each.getValue(), rollouts.get(each.getKey())));
        List<String> over = new ArrayList<>();
        try (KeyValueIterator<String, byte[]> each = tallies.all()) {
            while (each.hasNext()) {
                String key = each.next().key;
                String name = key.substring(0, key.lastIndexOf(' '));
                Rollout rollout = rolling(name);
                if (rollout == null || !key.equals(key(name, rollouts.get(name)))) {
                    over.add(key);
                }
            }
        }
        over.forEach(tallies::delete);
    }

    /** The rollout of this name; null if there is none that is rolling. */
    private @Nullable Rollout rolling(String name) {
        byte[] published = rollouts.get(name);
        try {
            Rollout rollout = published == null ? null : Rollout.read(name, published);
            return rollout == null || !rollout.isRolling() || Arrays.equals(stopped.get(name), published)
                    ? null
                    : rollout;
        } catch (Refusal unusable) {
            return null;
        }
    }

    /** Each step of a rollout, such as a larger share, is counted separately. */
    private static String key(String name, byte[] published) {
        return name + ' ' + Arrays.hashCode(published);
    }

    @Override
    public void process(Record<String, byte[]> record) {
        if (record.key() == null || record.value() == null || record.value().length != 2 * Long.BYTES) {
            // After an exception the record would be read again and again.
            LOG.error("a record of {} is ignored: this program did not write it", Topic.VERDICTS);
            return;
        }
        Rollout rollout = rolling(record.key());
        if (rollout == null) {
            return;
        }
        byte[] published = rollouts.get(record.key());
        String key = key(record.key(), published);
        byte[] before = tallies.get(key);
        ByteBuffer was = ByteBuffer.wrap(before == null ? verdict(0, 0) : before);
        ByteBuffer more = ByteBuffer.wrap(record.value());
        long good = was.getLong() + more.getLong();
        long bad = was.getLong() + more.getLong();
        tallies.put(key, verdict(good, bad));
        long all = good + bad;
        if (all >= rollout.stopAfter() && bad * 100.0 / all > rollout.stopPercent()) {
            String why = String.format(
                    Locale.ROOT,
                    "%d of %d were failures or divergences, more than %.1f %%",
                    bad,
                    all,
                    rollout.stopPercent());
            LOG.warn("the rollout {} is stopped and rolled back: {}", rollout.name(), why);
            stopped.put(record.key(), published);
            byte[] next = rollout.stoppedBecause(why).bytes();
            context.forward(new Record<>(record.key(), next, record.timestamp()), Topic.ROLLOUTS.name());
        }
    }
}
