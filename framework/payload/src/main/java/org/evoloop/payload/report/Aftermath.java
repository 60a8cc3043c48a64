package org.evoloop.payload.report;

import java.time.Duration;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.function.Consumer;
import org.evoloop.time.Clock;
import org.jspecify.annotations.Nullable;

/**
 * Tells which reports of a device's state count, since a report may be older than the effect of a command.
 *
 * <p>A command that was not confirmed may still have its effect for a while. Until then only the report of the state to
 * which it leads counts; the newest other one counts when that time is over. What is {@linkplain Report#old() old}
 * may be older than the command, however much later it arrives.
 *
 * <p>Threading: thread-safe.
 *
 * @since 0.1
 */
public final class Aftermath {
    /** What follows from the state, if it is reported when nothing is unknown. */
    private final Map<Consumer<String>, String> held = new LinkedHashMap<>();

    private final Turns turns;
    private volatile boolean old;
    private boolean sending;
    private boolean unknown;
    private String source = "";
    private String target = "";
    private Clock.@Nullable Timer timer;

    /**
     * Nothing is unknown.
     *
     * @param turns those of the reports
     */
    public Aftermath(Turns turns) {
        this.turns = turns;
    }

    /** A report has come; what it says is heard next. */
    public void receives(Report report) {
        old = report.old();
    }

    /** A command is sent that takes the device from one state to another. */
    synchronized void sends(String from, String to) {
        settled();
        sending = true;
        source = from;
        target = to;
    }

    /**
     * It is unknown whether the last command has had its effect. If it has not within the limit, it never will.
     *
     * @param to the state to which it leads; empty if that is not known either
     */
    synchronized void isUnknown(String to, Clock clock, Duration limit) {
        sending = false;
        unknown = true;
        target = to;
        stopTimer();
        timer = clock.schedule(limit, () -> turns.take(this::over));
    }

    /** The device's state is known. */
    synchronized void settled() {
        sending = false;
        unknown = false;
        held.clear();
        stopTimer();
    }

    /** The device cannot be heard any more: what it has reported so far may be outdated when it counts. */
    public synchronized void isLost() {
        held.clear();
    }

    private void stopTimer() {
        if (timer != null) {
            timer.cancel();
            timer = null;
        }
    }

    private void over() {
        Map<Consumer<String>, String> due;
        synchronized (this) {
            timer = null;
            due = Map.copyOf(held);
            if (!due.isEmpty()) {
                settled();
            }
        }
        due.forEach(Consumer::accept);
    }

    /**
     * The device has reported its state.
     *
     * @param then is told when it counts, unless it never does
     */
    public void hear(String state, Consumer<String> then) {
        if (counts(state, then)) {
            then.accept(state);
        }
    }

    private synchronized boolean counts(String state, Consumer<String> then) {
        boolean mayBeOld = !state.equals(target) && (unknown || (sending && state.equals(source)));
        boolean waits = sending || timer != null;
        if (mayBeOld && waits && !old) {
            held.put(then, state);
        }
        boolean counts = !mayBeOld || (!waits && !old);
        if (counts && unknown) {
            settled();
        }
        return counts;
    }
}
