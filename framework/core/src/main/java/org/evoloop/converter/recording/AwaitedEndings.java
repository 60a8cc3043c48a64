package org.evoloop.converter.recording;

import java.util.ArrayList;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.concurrent.ForkJoinPool;
import java.util.function.Consumer;
import org.evoloop.converter.attachment.Endings;
import org.evoloop.evolution.Configuration;
import org.evoloop.evolution.Decision;
import org.evoloop.evolution.EventOutcome;
import org.evoloop.evolution.Occurrence;
import org.evoloop.evolution.Outcome;
import org.evoloop.evolution.Step;
import org.evoloop.statemachine.Event;
import org.jspecify.annotations.Nullable;

/**
 * Who waits for the end of which occurrence. They are told on the JDK's common pool, since the core must not be given an
 * input while it says what follows from another; without threads, once the converter has taken its step.
 *
 * <p>Threading: thread-safe; costs nothing while nobody waits.
 */
public final class AwaitedEndings implements Endings {
    private final boolean threads;
    private final IdentityHashMap<Occurrence, Consumer<EventOutcome>> waiting = new IdentityHashMap<>();
    private final ConcurrentLinkedQueue<Runnable> due = new ConcurrentLinkedQueue<>();
    private volatile boolean any;
    private volatile boolean closed;

    /** @param threads whether the converter has any */
    public AwaitedEndings(boolean threads) {
        this.threads = threads;
    }

    @Override
    public void await(Occurrence occurrence, Consumer<EventOutcome> then) {
        synchronized (waiting) {
            waiting.put(occurrence, then);
            any = true;
        }
    }

    private @Nullable Consumer<EventOutcome> take(Occurrence occurrence) {
        synchronized (waiting) {
            Consumer<EventOutcome> then = waiting.remove(occurrence);
            any = !waiting.isEmpty();
            return then;
        }
    }

    void ended(
            Occurrence occurrence,
            Configuration before,
            Configuration after,
            Outcome outcome,
            @Nullable Decision decision,
            String detail) {
        if (any) {
            Consumer<EventOutcome> then = take(occurrence);
            if (then != null) {
                String words = HistoryLine.detail(decision, detail);
                tell(then, outcome(before, after, outcome, decision, words));
            }
        }
    }

    private static EventOutcome outcome(
            Configuration before, Configuration after, Outcome outcome, @Nullable Decision decision, String why) {
        return switch (outcome) {
            case HANDLED -> new EventOutcome.Handled(before, after, sent(decision));
            case IGNORED ->
                decision instanceof Decision.NotAcceptable
                        ? new EventOutcome.NotAcceptable(why)
                        : new EventOutcome.Refused(why);
            case STALE -> new EventOutcome.Stale(why);
            case DROPPED -> new EventOutcome.Dropped(why);
            case FAILED -> new EventOutcome.Failed(before, after, why);
            case OVERTAKEN -> new EventOutcome.Overtaken(before, after, why);
        };
    }

    private static List<Event> sent(@Nullable Decision decision) {
        return decision == null
                ? List.of()
                : decision.steps().stream()
                        .filter(step -> !step.byDevice())
                        .map(Step::trigger)
                        .toList();
    }

    @Override
    public void refused(Occurrence occurrence, String why) {
        if (any) {
            Consumer<EventOutcome> then = take(occurrence);
            if (then != null) {
                tell(then, new EventOutcome.Refused(why));
            }
        }
    }

    private void tell(Consumer<EventOutcome> then, EventOutcome ended) {
        if (threads && !closed) {
            ForkJoinPool.commonPool().execute(() -> then.accept(ended));
        } else {
            due.add(() -> then.accept(ended));
        }
    }

    /** Tells of those that have ended, in a converter without threads, on the caller's thread. */
    void deliver() {
        for (Runnable next = due.poll(); next != null; next = due.poll()) {
            next.run();
        }
    }

    /** The converter has been closed: what has not ended does not end any more. */
    void close() {
        closed = true;
        List<Consumer<EventOutcome>> left;
        synchronized (waiting) {
            left = new ArrayList<>(waiting.values());
            waiting.clear();
            any = false;
        }
        left.forEach(then -> then.accept(new EventOutcome.Refused("the converter was closed before its turn came")));
        deliver();
    }
}
