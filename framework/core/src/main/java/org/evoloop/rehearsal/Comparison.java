package org.evoloop.rehearsal;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.function.Consumer;
import org.evoloop.core.Input;
import org.evoloop.core.Outcome;
import org.evoloop.core.Pending;
import org.evoloop.core.Rules;
import org.evoloop.core.Snapshot;
import org.evoloop.core.Tally;
import org.evoloop.evolution.Configuration;
import org.evoloop.evolution.Occurrence;
import org.evoloop.evolution.Source;
import org.evoloop.statemachine.State;
import org.jspecify.annotations.Nullable;

/**
 * Gives other models the inputs of a converter, and compares both decisions on each event.
 *
 * <p>Each step and effect of the other models succeeds at once, unless one for the same event failed in the
 * converter. A guard holds if it held there. Timers are due by the other models' own deadlines. An event of a function
 * occurs only while both new models are in the same state.
 *
 * <p>Threading: not thread-safe.
 *
 * @since 0.1
 */
public final class Comparison {
    private final Compared compared;
    private final Consumer<Ending> endings;
    private @Nullable Rehearsal other;

    /** How the event that has its turn ended in the converter. */
    private @Nullable Ending recorded;

    /** How it ended in the other models. */
    private @Nullable Ending answered;

    /** How events ended in the other models that have not ended in the converter. */
    private final List<Ending> early = new ArrayList<>();

    /** Receives the comparison of an event. */
    @FunctionalInterface
    public interface Compared {
        /**
         * An event was handled by both, or by one of the two.
         *
         * @param then the converter's verdict; null for a timer that it does not have
         * @param now the other models' verdict; null if it would not have happened
         */
        void compared(Occurrence occurrence, @Nullable Verdict then, @Nullable Verdict now);
    }

    /** @param endings receives every event that the other models have handled */
    public Comparison(Compared compared, Consumer<Ending> endings) {
        this.compared = compared;
        this.endings = endings;
    }

    /** A snapshot in which nothing has happened yet: closed, and no timer runs. */
    public static Snapshot still(Configuration at, long nowNanos) {
        return still(false, at, new Snapshot.OpenVisit(0, true, null, Map.of()), List.of(), nowNanos);
    }

    /**
     * A snapshot in the states of {@code from}, with its timers; of its queue, only a takeover that has not settled
     * yet.
     */
    public static Snapshot still(Snapshot from) {
        List<Pending> waiting = from.waiting().stream()
                .filter(pending -> pending.occurrence() instanceof Occurrence.Evolved)
                .toList();
        return still(from.open(), from.at(), from.visit(), waiting, from.nowNanos());
    }

    private static Snapshot still(
            boolean open, Configuration at, Snapshot.OpenVisit visit, List<Pending> waiting, long nowNanos) {
        Tally nothing = new Tally(0, 0, 0, 0, 0, 0, 0, 0, 0);
        return new Snapshot(open, at, null, 0, nowNanos, visit, waiting, false, false, null, nothing, nowNanos);
    }

    /** The other models begin, or continue in another process, after {@link #rest}. */
    public void begin(Rules rules, Snapshot from) {
        other = new Rehearsal(rules, from, this::recordedOf, this::otherEnded);
    }

    private Rehearsal other() {
        if (other == null) {
            throw new IllegalStateException("it has not begun");
        }
        return other;
    }

    /** The states in which device and evolved system would be. */
    public Configuration at() {
        return other().at();
    }

    /**
     * An event was observed.
     *
     * @param raisedIn the state of the converter's new model, if the event belongs to its visit; null if it belongs to
     *     an older one
     */
    public void observed(Occurrence occurrence, @Nullable State raisedIn, long atNanos) {
        other().hear(occurrence, raisedIn, atNanos);
    }

    /** The converter was opened or closed, or recovered in a new process; other inputs are ignored. */
    public void follow(Input input, long atNanos) {
        other().follow(input, atNanos);
    }

    /** An event has ended in the converter. */
    public void ended(Ending ending, long atNanos) {
        Occurrence occurrence = ending.ended().occurrence();
        if (occurrence instanceof Occurrence.Found && !other().awaits(occurrence) && early(occurrence) == null) {
            // No monitor has reported it: the device was asked, or obeyed late.
            other().find(occurrence, atNanos);
        }
        recorded = ending;
        answered = null;
        other().turn(occurrence, atNanos);
        recorded = null;
        Ending answer = answered;
        if (answer == null) {
            answer = early(occurrence);
            early.remove(answer);
        }
        if (ending.ended().outcome() != Outcome.STALE) {
            Verdict now = answer != null ? answer.verdict() : isNoNews(ending) ? ending.verdict() : null;
            compared.compared(occurrence, ending.verdict(), now);
        }
    }

    /** Whether the device was found, and the other models are where that led: they have no doubts. */
    private boolean isNoNews(Ending ending) {
        return ending.ended().occurrence() instanceof Occurrence.Found
                && ending.ended().after().equals(other().at());
    }

    /** Time has passed: timers that only the other models have get their turns. */
    public void pass(long atNanos) {
        other().fire(atNanos);
    }

    /** Nothing more comes from this process: waiting events get their turns. */
    public void rest(long atNanos) {
        if (other != null) {
            other.rest(atNanos);
        }
    }

    private @Nullable Ending recordedOf(Occurrence occurrence) {
        return recorded != null && Rehearsal.isSame(occurrence, recorded.ended().occurrence()) ? recorded : null;
    }

    private @Nullable Ending early(Occurrence occurrence) {
        for (Ending each : early) {
            if (Rehearsal.isSame(each.ended().occurrence(), occurrence)) {
                return each;
            }
        }
        return null;
    }

    private void otherEnded(Ending ending) {
        Occurrence occurrence = ending.ended().occurrence();
        endings.accept(ending);
        if (answered == null && recordedOf(occurrence) != null) {
            answered = ending;
        } else if (occurrence.source() != Source.TIMER) {
            early.add(ending);
        } else if (ending.ended().outcome() != Outcome.STALE) {
            compared.compared(occurrence, null, ending.verdict());
        }
    }
}
