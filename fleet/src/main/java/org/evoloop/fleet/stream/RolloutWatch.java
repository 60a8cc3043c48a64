package org.evoloop.fleet.stream;

import java.nio.ByteBuffer;
import java.util.Arrays;
import java.util.HashSet;
import java.util.Locale;
import java.util.Set;
import org.apache.kafka.streams.processor.api.Processor;
import org.apache.kafka.streams.processor.api.ProcessorContext;
import org.apache.kafka.streams.processor.api.Record;
import org.apache.kafka.streams.state.KeyValueStore;
import org.evoloop.fleet.wire.Refusal;
import org.evoloop.fleet.wire.Rollout;
import org.evoloop.fleet.wire.Topic;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** Counts the results of devices that have the models of a rollout, and stops a rollout with too many failures. */
final class RolloutWatch implements Processor<String, byte[], String, byte[]> {
    static final String STORE = "rollout-tallies";

    private static final Logger LOG = LoggerFactory.getLogger(RolloutWatch.class);

    /** The rollouts stopped already, although the global copy may not show it yet. */
    private final Set<String> stopped = new HashSet<>();

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
    }

    @Override
    public void process(Record<String, byte[]> record) {
        if (record.key() == null || record.value() == null || record.value().length != 2 * Long.BYTES) {
            // After an exception the record would be read again and again.
            LOG.error("a record of {} is ignored: this program did not write it", Topic.VERDICTS);
            return;
        }
        byte[] published = rollouts.get(record.key());
        if (published == null) {
            return;
        }
        Rollout rollout;
        try {
            rollout = Rollout.read(record.key(), published);
        } catch (Refusal unusable) {
            return;
        }
        // Each step of a rollout, such as a larger share, is counted separately.
        String key = record.key() + ' ' + Arrays.hashCode(published);
        byte[] before = tallies.get(key);
        ByteBuffer was = ByteBuffer.wrap(before == null ? verdict(0, 0) : before);
        ByteBuffer more = ByteBuffer.wrap(record.value());
        long good = was.getLong() + more.getLong();
        long bad = was.getLong() + more.getLong();
        tallies.put(key, verdict(good, bad));
        long all = good + bad;
        if (rollout.isRolling()
                && all >= rollout.stopAfter()
                && bad * 100.0 / all > rollout.stopPercent()
                && stopped.add(key)) {
            String why = String.format(
                    Locale.ROOT,
                    "%d of %d were failures or divergences, more than %.1f %%",
                    bad,
                    all,
                    rollout.stopPercent());
            LOG.warn("the rollout {} is stopped and rolled back: {}", rollout.name(), why);
            byte[] stopped = rollout.stoppedBecause(why).bytes();
            context.forward(new Record<>(record.key(), stopped, record.timestamp()), Topic.ROLLOUTS.name());
        }
    }
}
