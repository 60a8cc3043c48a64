package org.evoloop.check.timing;

import java.util.Arrays;

/**
 * Monitors one time property, storing as little of the past as it needs. The same monitors are used while a converter
 * runs, in nanoseconds, and before it runs for everything that can happen, in ticks. Nothing is allocated after
 * creation.
 *
 * <p>It gets each moment in order, possibly several at the same time: whether the property's subject and its other
 * formula hold. For an event it gets one moment with the event and one without.
 *
 * <p>Threading: not thread-safe.
 *
 * @since 0.1
 */
public abstract sealed class TimeMonitor {
    /** No time. */
    public static final long NONE = Long.MIN_VALUE;

    /** How many beginnings of a response are told apart while a converter runs. */
    private static final int WAITING = 1024;

    /** The stored times. */
    final long[] marks;

    /** The last observation: bit 0 is the subject, bit 1 the other. */
    int seen;

    /** The duration that has just ended, or the count; {@link #NONE} if none has. */
    long measured = NONE;

    private TimeMonitor(int marks) {
        this.marks = new long[marks];
        clear();
    }

    /**
     * A monitor with times in units of {@code unitNanos}, of which all durations in {@code form} are multiples. It finds
     * each violation, as long as at most 1,024 beginnings of a response wait at once.
     */
    public static TimeMonitor of(TimeForm form, long unitNanos) {
        return of(form, unitNanos, WAITING);
    }

    /**
     * A monitor that finds the first violation, with as little memory as that takes. For that, the oldest and the newest
     * beginning that wait are enough.
     */
    static TimeMonitor ofFirst(TimeForm form, long unitNanos) {
        return of(form, unitNanos, 2);
    }

    private static TimeMonitor of(TimeForm form, long unitNanos, int waiting) {
        if (form instanceof TimeForm.Response response) {
            return new Response(
                    response.span().minNanos() / unitNanos, response.span().maxNanos() / unitNanos, waiting);
        } else if (form instanceof TimeForm.Stay stay) {
            long max = stay.span().maxNanos();
            return new Stay(stay.span().minNanos() / unitNanos, max == Span.FOR_EVER ? max : max / unitNanos);
        } else if (form instanceof TimeForm.Before before) {
            return new Before(before.minNanos() / unitNanos);
        }
        TimeForm.Count count = (TimeForm.Count) form;
        return new Count(count.most(), count.windowNanos() / unitNanos);
    }

    /** Forgets all. */
    public final void clear() {
        Arrays.fill(marks, NONE);
        seen = 0;
    }

    /**
     * A moment.
     *
     * @param now not before any earlier time; {@link #lapsed} must have been called for it, until it returned false
     * @return whether this violates the property
     */
    public final boolean sees(long now, boolean subject, boolean other) {
        measured = NONE;
        boolean begins = subject && (seen & 1) == 0;
        boolean ends = !subject && (seen & 1) != 0;
        seen = (subject ? 1 : 0) | (other ? 2 : 0);
        return moment(now, begins, ends, other);
    }

    abstract boolean moment(long now, boolean begins, boolean ends, boolean other);

    /** The last time at which it is not violated if nothing happens; {@link #NONE} if there is none. */
    public long deadline() {
        return NONE;
    }

    /**
     * Advances the time to {@code now}, with nothing having happened since the last moment; returns whether that
     * violates the property. To be called again until it does not, since each beginning has a deadline of its own.
     */
    public final boolean lapsed(long now) {
        long deadline = deadline();
        boolean late = deadline != NONE && now > deadline;
        if (late) {
            System.arraycopy(marks, 1, marks, 0, marks.length - 1);
            marks[marks.length - 1] = NONE;
        }
        return late;
    }

    /** Forgets what is no longer relevant, so that there are finitely many situations. */
    abstract void forget(long now);

    static long max(long one, long other) {
        return one == NONE ? NONE : Math.max(one, other);
    }

    /** When those began that wait, the oldest first; if there are too many, the newest replaces the one before it. */
    private static final class Response extends TimeMonitor {
        private final long min;
        private final long max;

        Response(long min, long max, int waiting) {
            super(waiting);
            this.min = min;
            this.max = max;
        }

        @Override
        boolean moment(long now, boolean begins, boolean ends, boolean other) {
            int newest = newest();
            if (begins && (newest < 0 || marks[newest] != now)) {
                newest = Math.min(newest + 1, marks.length - 1);
                marks[newest] = now;
            }
            if (newest < 0 || !other) {
                return false;
            }
            measured = now - marks[0];
            boolean broken = measured > max || now - marks[newest] < min;
            Arrays.fill(marks, 0, newest + 1, NONE);
            return broken;
        }

        private int newest() {
            int newest = -1;
            while (newest + 1 < marks.length && marks[newest + 1] != NONE) {
                newest++;
            }
            return newest;
        }

        @Override
        public long deadline() {
            return marks[0] == NONE ? NONE : marks[0] + max;
        }

        /** Until the first violation, the newest matters only while it can be answered too soon. */
        @Override
        void forget(long now) {
            marks[1] = marks[1] != NONE && now - marks[1] < min ? marks[1] : NONE;
        }
    }

    /** Since it lasts. */
    private static final class Stay extends TimeMonitor {
        private final long min;
        private final long max;

        Stay(long min, long max) {
            super(1);
            this.min = min;
            this.max = max;
        }

        @Override
        boolean moment(long now, boolean begins, boolean ends, boolean other) {
            boolean broken = false;
            if (begins) {
                marks[0] = now;
            } else if (ends && marks[0] != NONE) {
                measured = now - marks[0];
                broken = measured < min || measured > max;
                marks[0] = NONE;
            }
            return broken;
        }

        @Override
        public long deadline() {
            return marks[0] == NONE || max == Span.FOR_EVER ? NONE : marks[0] + max;
        }

        @Override
        void forget(long now) {
            marks[0] = max == Span.FOR_EVER ? max(marks[0], now - min - 1) : marks[0];
        }
    }

    /** Since the other lasts, and when it ended. */
    private static final class Before extends TimeMonitor {
        private final long min;

        Before(long min) {
            super(2);
            this.min = min;
        }

        @Override
        boolean moment(long now, boolean begins, boolean ends, boolean other) {
            boolean broken = false;
            if (begins) {
                boolean lasted = marks[0] != NONE && (marks[1] == NONE || marks[1] == now);
                measured = lasted ? now - marks[0] : 0;
                broken = measured < min || !lasted;
            }
            if (other && (marks[0] == NONE || marks[1] != NONE)) {
                marks[0] = now;
                marks[1] = NONE;
            } else if (!other && marks[0] != NONE && marks[1] == NONE) {
                marks[1] = now;
            }
            return broken;
        }

        @Override
        void forget(long now) {
            if (marks[1] != NONE && marks[1] < now) {
                marks[0] = NONE;
                marks[1] = NONE;
            }
            marks[0] = max(marks[0], now - min - 1);
        }
    }

    /** When it began, the last times, the oldest first. */
    private static final class Count extends TimeMonitor {
        private final long window;

        Count(int most, long window) {
            super(most);
            this.window = window;
        }

        @Override
        boolean moment(long now, boolean begins, boolean ends, boolean other) {
            if (!begins) {
                return false;
            }
            measured = 1;
            for (long mark : marks) {
                measured += mark != NONE && now - mark <= window ? 1 : 0;
            }
            boolean broken = measured > marks.length;
            System.arraycopy(marks, 1, marks, 0, marks.length - 1);
            marks[marks.length - 1] = now;
            return broken;
        }

        @Override
        void forget(long now) {
            for (int index = 0; index < marks.length; index++) {
                marks[index] = marks[index] != NONE && now - marks[index] > window ? NONE : marks[index];
            }
        }
    }
}
