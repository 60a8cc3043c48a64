package org.evoloop.fleet.wire;

import java.util.ArrayList;
import java.util.List;
import org.evoloop.engine.Output;
import org.evoloop.engine.Snapshot;
import org.evoloop.evolution.Occurrence;
import org.evoloop.fleet.device.DeviceListener;
import org.evoloop.fleet.device.DeviceState;
import org.evoloop.fleet.device.Order;
import org.jspecify.annotations.Nullable;

/**
 * The outgoing records of a device for one incoming record or one tick.
 *
 * <p>Threading: not thread-safe.
 *
 * @since 0.1
 */
public final class Letters implements DeviceListener {
    private final List<Letter> letters = new ArrayList<>();
    private String model = "";
    private @Nullable DeviceState before;
    private long good;
    private long bad;

    /** A record for a topic. */
    @SuppressWarnings("ArrayRecordComponent") // nobody compares letters
    public record Letter(Topic topic, byte[] text) {}

    /**
     * Clears the records and starts with a device that has the models {@code version} and the state {@code state}, null
     * if it is new.
     */
    public void begin(String version, @Nullable DeviceState state) {
        letters.clear();
        before = state;
        model = version;
        good = 0;
        bad = 0;
    }

    /** Sets the model version of later records. */
    public void becomes(String version) {
        model = version;
    }

    @Override
    public void ordered(Order order) {
        add(Topic.COMMANDS, Wire.command(order));
    }

    @Override
    public void noted(Output.Notice notice) {
        byte[] decision = Wire.decision(model, notice);
        if (decision != null) {
            add(Topic.DECISIONS, decision);
        }
        if (notice instanceof Output.Ended ended) {
            judge(ended);
        } else if (notice instanceof Output.Doubted doubted && !doubted.why().isEmpty()) {
            bad++;
        }
    }

    /** A device found in another state has done something that its models do not describe. */
    private void judge(Output.Ended ended) {
        boolean diverged = ended.occurrence() instanceof Occurrence.Found
                && !ended.before().equals(ended.after());
        if (ended.outcome().isIncomplete() || diverged) {
            bad++;
        } else {
            good++;
        }
    }

    @Override
    public void settled(DeviceState state, boolean isNew) {
        if (before == null || !isSame(before, state, isNew)) {
            add(Topic.STATES, Wire.state(state, isNew));
        }
        before = state;
    }

    private static boolean isSame(DeviceState one, DeviceState other, boolean isNew) {
        Snapshot.OpenVisit visit = one.snapshot().visit();
        Snapshot.OpenVisit next = other.snapshot().visit();
        return one.model().equals(other.model())
                && one.snapshot().at().equals(other.snapshot().at())
                && visit.number() == next.number()
                && visit.deadlines().equals(next.deadlines())
                && (visit.over() == next.over() || !isNew)
                && (one.snapshot().doubt() == null) == (other.snapshot().doubt() == null);
    }

    /** Adds a record. */
    public void add(Topic topic, byte[] text) {
        letters.add(new Letter(topic, text));
    }

    /** The number of successes. */
    public long good() {
        return good;
    }

    /** The number of failures, and of findings that differ from the models. */
    public long bad() {
        return bad;
    }

    /** All records, in order. */
    public List<Letter> all() {
        return letters;
    }
}
