package org.evoloop.converter.recording;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import org.evoloop.converter.Drift;
import org.evoloop.converter.running.CoreDriver;
import org.evoloop.evolution.Step;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.State;
import org.evoloop.time.Clock;
import org.jspecify.annotations.Nullable;

/**
 * The last {@value #SIZE} acts of the device, and which of them its model does not have. An act leads to the state that the
 * device reports next, if that comes soon; a report that comes later, or after another one, is an act that nobody has seen.
 * It allocates nothing but for an edge that it has not seen before.
 *
 * <p>Threading: guarded by the lock of the {@link CoreDriver}.
 */
public final class DriftWindow {
    private static final int SIZE = 200;

    /** How soon a report must come to be about the last act. */
    private static final long SOON = Duration.ofSeconds(10).toNanos();

    private static final int IN_MODEL = -1;

    private final Clock clock;

    /** The kind of each act: a place in {@link #kinds}. */
    private final int[] acts = new int[SIZE];

    private final List<Kind> kinds = new ArrayList<>();
    private int recorded;
    private int next;

    /** The last act, until a report shows where it has led. */
    private boolean open;

    private @Nullable State source;
    private @Nullable State target;
    private @Nullable Event event;
    private long since;

    /** A step that was sent, and may or may not have had its effect; null if there is none. */
    private @Nullable Step unsure;

    /** Whether the device has reported a state or acted since {@link #begin}; before, it may have been anywhere. */
    private boolean known;

    private static final class Kind {
        private final State source;
        private final @Nullable Event event;
        private final @Nullable State target;
        private int count;

        Kind(State source, @Nullable Event event, @Nullable State target) {
            this.source = source;
            this.event = event;
            this.target = target;
        }

        boolean is(State otherSource, @Nullable Event otherEvent, @Nullable State otherTarget) {
            return source.equals(otherSource)
                    && Objects.equals(event, otherEvent)
                    && Objects.equals(target, otherTarget);
        }
    }

    public DriftWindow(Clock clock) {
        this.clock = clock;
    }

    /** Forgets everything: from now on other models hold. */
    public void begin() {
        kinds.clear();
        recorded = 0;
        next = 0;
        open = false;
        unsure = null;
        known = false;
    }

    /**
     * The device has acted by itself.
     *
     * @param own the step that the model has for it; null if it has none
     */
    public void acted(Event acted, State from, @Nullable Step own) {
        add(own == null ? kind(from, acted, null) : IN_MODEL);
        await(from, acted, own == null ? null : own.target());
    }

    /** A step is sent. */
    public void sent(Step step) {
        unsure = step;
    }

    /** A step has had its effect. */
    public void took(Step step) {
        add(IN_MODEL);
        await(step.source(), step.trigger(), step.target());
    }

    /** The device says that it is in {@code state}. */
    public void reported(State state, State recordedState) {
        boolean soon = clock.nanoTime() - since <= SOON;
        Step doubted = unsure;
        State from = source;
        if (open && soon && from != null) {
            if (target != null && state.equals(from) && !state.equals(target)) {
                // It may have said so before the act.
                return;
            }
            if (target == null || !state.equals(target)) {
                replaceLast(kind(from, event, state));
            }
        } else if (doubted != null && !state.equals(doubted.target()) && !state.equals(doubted.source())) {
            add(kind(doubted.source(), doubted.trigger(), state));
        } else if (known && doubted == null && !state.equals(recordedState)) {
            add(kind(recordedState, null, state));
        }
        open = false;
        unsure = null;
        known = true;
    }

    private void await(State from, Event by, @Nullable State to) {
        open = true;
        source = from;
        event = by;
        target = to;
        since = clock.nanoTime();
        unsure = null;
        known = true;
    }

    private int kind(State from, @Nullable Event by, @Nullable State to) {
        int free = IN_MODEL;
        for (int i = 0; i < kinds.size(); i++) {
            if (kinds.get(i).is(from, by, to)) {
                return i;
            }
            free = kinds.get(i).count == 0 ? i : free;
        }
        Kind fresh = new Kind(from, by, to);
        if (free == IN_MODEL) {
            kinds.add(fresh);
            return kinds.size() - 1;
        }
        kinds.set(free, fresh);
        return free;
    }

    private void add(int kind) {
        if (recorded == SIZE) {
            count(acts[next], -1);
        } else {
            recorded++;
        }
        acts[next] = kind;
        count(kind, 1);
        next = (next + 1) % SIZE;
    }

    private void replaceLast(int kind) {
        int last = (next + SIZE - 1) % SIZE;
        count(kind, 1);
        count(acts[last], -1);
        acts[last] = kind;
    }

    private void count(int kind, int more) {
        if (kind != IN_MODEL) {
            kinds.get(kind).count += more;
        }
    }

    public Drift summary() {
        return new Drift(
                recorded,
                kinds.stream()
                        .filter(kind -> kind.count > 0)
                        .map(kind -> new Drift.Edge(kind.source, kind.event, kind.target, kind.count))
                        .toList());
    }
}
