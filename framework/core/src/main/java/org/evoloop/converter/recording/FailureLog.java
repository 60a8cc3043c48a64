package org.evoloop.converter.recording;

import java.time.Duration;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.RejectedExecutionException;
import java.util.function.Consumer;
import org.evoloop.converter.ConverterStatus;
import org.evoloop.converter.SystemEventConverter;
import org.evoloop.evolution.Occurrence;
import org.evoloop.loop.Failure;
import org.evoloop.loop.LoopConfig;
import org.evoloop.time.Clock;
import org.evoloop.time.Threads;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;
import org.slf4j.event.Level;
import org.slf4j.spi.LoggingEventBuilder;

/**
 * Logs failures and warnings without flooding the log: of equal ones the first, the second, the fourth, the eighth, and
 * so on; of all together {@value #MOST_LINES} in {@value #INTERVAL_SECONDS} s, and how many more there were. Counts the
 * failures of parts that are not components.
 *
 * <p>Threading: thread-safe.
 */
public final class FailureLog {
    private static final Logger LOG = LoggerFactory.getLogger(SystemEventConverter.class);
    private static final int DISTINCT = 100;
    private static final int MOST_LINES = 20;
    private static final int INTERVAL_SECONDS = 10;

    private final Clock clock;
    private final boolean threads;
    private final String converter;
    private final ArrayDeque<String> soon = new ArrayDeque<>();
    private boolean saying;
    private volatile Consumer<Failure<Occurrence>> listener = failure -> {};
    private final Map<String, Long> counts = new LinkedHashMap<>();
    private final Map<String, ConverterStatus.Fault> faults = new LinkedHashMap<>();
    private long intervalNanos;
    private int lines;
    private long leftOut;

    /** @param config its clock measures the intervals */
    public FailureLog(LoopConfig config) {
        this.clock = config.clock();
        this.threads = config.threads();
        this.converter = config.name();
        this.intervalNanos = clock.nanoTime();
    }

    public void log(Failure<?> failure) {
        String what = failure.toString();
        long count = count(what);
        if (count > 1 || !isBug(failure.cause())) {
            warn(what, count, about(failure));
        } else if (mayLog()) {
            LoggingEventBuilder line = Keys.at(LOG, Level.ERROR, converter, about(failure));
            try {
                line.setCause(failure.cause()).log("{}", what);
            } catch (RuntimeException badCause) {
                LOG.error("{}", what);
            }
        }
    }

    private static String about(Failure<?> failure) {
        return failure.occurrence() instanceof Occurrence occurrence ? occurrence.label() : "";
    }

    /** From now on, {@code told} hears of every {@link #fault}; it must return at once. */
    public void tell(Consumer<Failure<Occurrence>> told) {
        listener = told;
    }

    /**
     * Logs and counts a failure of {@code part}, such as {@code guard [full]}, which is not a component and has no
     * count of its own, and tells of it.
     */
    public void fault(String part, Failure<Occurrence> failure) {
        note(part, failure);
        listener.accept(failure);
    }

    /** As {@link #fault}, but tells nobody: for failures that are reported in another way, and those of listeners. */
    public void note(String part, Failure<?> failure) {
        countFault(part, failure.toString());
        log(failure);
    }

    /** Only counts a failure of {@code part}. */
    synchronized void countFault(String part, String message) {
        if (faults.size() < DISTINCT || faults.containsKey(part)) {
            ConverterStatus.Fault before = faults.get(part);
            faults.put(part, new ConverterStatus.Fault(part, before == null ? 1 : before.failures() + 1, message));
        }
    }

    /** A part that had failed works again. */
    synchronized void forget(String part) {
        faults.remove(part);
    }

    /** The parts that are not components and have failed, in the order of their first failures. */
    public synchronized List<ConverterStatus.Fault> faults() {
        return new ArrayList<>(faults.values());
    }

    /**
     * Logs a warning that is not a component's failure.
     *
     * @param what the same text each time the same thing happens
     */
    public void warn(String what) {
        warn(what, count(what), "");
    }

    private void warn(String what, long count, String event) {
        if (isDue(count)) {
            Keys.at(LOG, Level.WARN, converter, event).log("{}", line(what, count));
        }
    }

    /**
     * As {@link #warn}, for callers that hold a lock: it never blocks, so no thread waits at that lock for a slow log.
     */
    public void warnSoon(String what) {
        long count = count(what);
        if (!isDue(count)) {
            return;
        }
        if (!willSay(line(what, count))) {
            leaveOut();
        } else if (isToBeSaidNow()) {
            if (threads) {
                // A thread for as long as there is something to say; the queue it empties is bounded.
                Threads.start("mapek-log", this::saySoon);
            } else {
                saySoon();
            }
        }
    }

    private synchronized boolean willSay(String line) {
        return soon.size() < DISTINCT && soon.add(line);
    }

    private synchronized boolean isToBeSaidNow() {
        boolean now = !saying;
        saying = true;
        return now;
    }

    private void saySoon() {
        for (String line = nextLine(); line != null; line = nextLine()) {
            Keys.at(LOG, Level.WARN, converter, "").log("{}", line);
        }
    }

    private synchronized @Nullable String nextLine() {
        String line = soon.poll();
        saying = line != null;
        return line;
    }

    private static String line(String what, long count) {
        return count == 1 ? what : what + " (" + count + " times)";
    }

    private boolean isDue(long count) {
        return Long.bitCount(count) == 1 && mayLog();
    }

    /** A stack trace helps the author of a component, but not a user who unplugged the device. */
    private static boolean isBug(Throwable cause) {
        return cause.getClass().getName().startsWith("java.")
                && (cause instanceof RuntimeException || cause instanceof Error);
    }

    private synchronized long count(String what) {
        if (counts.size() >= DISTINCT && !counts.containsKey(what)) {
            counts.remove(counts.keySet().iterator().next());
        }
        long count = counts.getOrDefault(what, 0L) + 1;
        counts.put(what, count);
        return count;
    }

    /** Whether there is room for one more line in this interval. */
    private boolean mayLog() {
        synchronized (this) {
            if (clock.nanoTime() - intervalNanos
                    >= Duration.ofSeconds(INTERVAL_SECONDS).toNanos()) {
                intervalNanos = clock.nanoTime();
                lines = 0;
            }
            if (lines < MOST_LINES) {
                lines++;
                return true;
            }
        }
        leaveOut();
        return false;
    }

    private void leaveOut() {
        // Neither the clock nor the log is called under the lock: both may be slow.
        boolean isFirst;
        synchronized (this) {
            isFirst = leftOut++ == 0;
        }
        if (isFirst) {
            sayLater();
        }
    }

    private void sayLater() {
        try {
            clock.schedule(Duration.ofSeconds(INTERVAL_SECONDS), this::sayLeftOut);
        } catch (RejectedExecutionException closed) {
            sayLeftOut();
        }
    }

    private void sayLeftOut() {
        long more;
        synchronized (this) {
            more = leftOut;
            leftOut = 0;
        }
        LOG.warn("{} more different warnings were left out; status counts the failures", more);
    }
}
