package org.evoloop.converter.running;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;
import org.evoloop.evolution.Configuration;
import org.evoloop.evolution.ModelPair;
import org.evoloop.evolution.Occurrence;
import org.evoloop.evolution.Sentry;
import org.evoloop.evolution.Source;
import org.evoloop.evolution.Values;
import org.evoloop.time.Clock;
import org.jspecify.annotations.Nullable;

/**
 * Feeds a sentry with events and the time, and hands the violations that it finds to the loop. It has at most one task
 * waiting at the clock, which reschedules itself: events schedule none.
 *
 * <p>Threading: guarded by the lock of the {@link CoreDriver}; violations are handed over on the clock's thread,
 * without it.
 */
final class SentryFeed {
    private final Clock clock;
    private final Sentry.@Nullable Posting posting;
    private @Nullable Sentry sentry;
    private @Nullable Object lock;
    private @Nullable Consumer<Occurrence> loop;
    private Clock.@Nullable Timer timer;
    private long setNanos;

    /** @param posting null if nothing is watched */
    SentryFeed(Clock clock, Sentry.@Nullable Posting posting) {
        this.clock = clock;
        this.posting = posting;
    }

    /** Called before the first input. */
    void attach(Object driver, Consumer<Occurrence> takes) {
        lock = driver;
        loop = takes;
    }

    /** Models have begun to run. */
    void begin(ModelPair models, Configuration at) {
        if (posting != null) {
            sentry = posting.post(models, at, clock.nanoTime());
            set();
        }
    }

    /** An occurrence comes; a violation itself is not watched. */
    void comes(Occurrence occurrence, Configuration at) {
        Sentry posted = sentry;
        if (posted != null && occurrence instanceof Occurrence.Heard heard) {
            posted.comes(heard.event(), at, heard.observedNanos());
            set();
        }
    }

    void moved(Configuration at) {
        Sentry posted = sentry;
        if (posted != null) {
            posted.moved(at, clock.nanoTime());
            set();
        }
    }

    /** Schedules the next task of the clock; it may run too early. */
    private void set() {
        long due = sentry == null ? Sentry.NEVER : sentry.dueNanos();
        if (due == Sentry.NEVER || (timer != null && setNanos - due <= 0)) {
            return;
        }
        if (timer != null) {
            timer.cancel();
        }
        setNanos = due;
        timer = clock.schedule(Duration.ofNanos(Math.max(0, due - clock.nanoTime())), this::ring);
    }

    private void ring() {
        Object guard = lock;
        Consumer<Occurrence> takes = loop;
        if (guard != null && takes != null) {
            List<Occurrence> found = new ArrayList<>();
            synchronized (guard) {
                look(found);
            }
            found.forEach(takes);
        }
    }

    private void look(List<Occurrence> found) {
        timer = null;
        Sentry posted = sentry;
        if (posted == null) {
            return;
        }
        long now = clock.nanoTime();
        posted.passed(now);
        for (Sentry.Violation each = posted.poll(); each != null; each = posted.poll()) {
            found.add(new Occurrence.Violated(each.property(), now));
            if (each.raised() != null) {
                Values why = Values.of("violated", each.property());
                found.add(new Occurrence.Heard(each.raised(), why, Source.PROPERTY, Occurrence.ANY_VISIT, now));
            }
        }
        set();
    }
}
