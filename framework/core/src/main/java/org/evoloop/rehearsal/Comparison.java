package org.evoloop.rehearsal;

import java.util.ArrayList;
import java.util.Iterator;
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
 * Tells other models what a converter is told, and compares what both make of each event.
 *
 * <p>Each step and effect of the other models succeeds at once, unless a step for the same event failed in the converter;
 * guards hold that held there; timers are due by the other models' own deadlines; an event of a function occurs only while
 * both new models are in the same state.
 *
 * <p>Threading: not thread-safe.
 *
 * @since 0.1
 */
public final class Comparison {
    private final Compared compared;
    private final Consumer<Ending> endings;
    private @Nullable Rehearsal other;

    /** What the converter made of the event that has its turn. */
    private @Nullable Ending recorded;

    /** What the other models made of it. */
    private @Nullable Ending answered;

    /** What the other models made of events that have not come to their end in the converter. */
    private final List<Ending> early = new ArrayList<>();

    /** Hears what came of an event. */
    @FunctionalInterface
    public interface Compared {
        /**
         * An event was dealt with by both, or by one of the two.
         *
         * @param then what the converter made of it; null for a timer that it does not have
         * @param now what the other models make of it; null if it would not have happened
         */
        void compared(Occurrence occurrence, @Nullable Verdict then, @Nullable Verdict now);
    }

    /** @param endings hears of every event that the other models have dealt with */
    public Comparison(Compared compared, Consumer<Ending> endings) {
        this.compared = compared;
        this.endings = endings;
    }

    /** Where nothing has happened yet: closed, and no timer runs. */
    public static Snapshot still(Configuration at, long nowNanos) {
        return still(false, at, new Snapshot.OpenVisit(0, true, null, Map.of()), List.of(), nowNanos);
    }

    /** Where {@code from} is, with its timers; of what waits, only that the device has to follow other models. */
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

    /** The other models begin, or go on in another process, after {@link #rest}. */
    public void begin(Rules rules, Snapshot from) {
        other = new Rehearsal(rules, from, this::recordedOf, this::otherEnded);
    }

    private Rehearsal other() {
        if (other == null) {
            throw new IllegalStateException("it has not begun");
        }
        return other;
    }

    /** Where device and evolved system would be. */
    public Configuration at() {
        return other().at();
    }

    /**
     * An event was observed.
     *
     * @param raisedIn the state of the converter's new model, if the event belongs to its visit; null if it does to an older one
     */
    public void observed(Occurrence occurrence, @Nullable State raisedIn, long atNanos) {
        other().hear(occurrence, raisedIn, atNanos);
    }

    /** The converter was opened or closed, or its process was; other inputs are ignored. */
    public void follow(Input input, long atNanos) {
        other().follow(input, atNanos);
    }

    /** An event has come to its end in the converter. */
    public void ended(Ending ending, long atNanos) {
        Occurrence occurrence = ending.ended().occurrence();
        recorded = ending;
        answered = null;
        other().turn(occurrence, atNanos);
        recorded = null;
        Ending answer = answered == null ? earlyFor(occurrence) : answered;
        if (ending.ended().outcome() != Outcome.STALE) {
            compared.compared(occurrence, ending.verdict(), answer == null ? null : answer.verdict());
        }
    }

    /** Time has passed: timers have their turns that only the other models have. */
    public void pass(long atNanos) {
        other().fire(atNanos);
    }

    /** Nothing more comes from this process: what waits has its turn. */
    public void rest(long atNanos) {
        if (other != null) {
            other.rest(atNanos);
        }
    }

    private @Nullable Ending recordedOf(Occurrence occurrence) {
        return recorded != null && Rehearsal.isSame(occurrence, recorded.ended().occurrence()) ? recorded : null;
    }

    private @Nullable Ending earlyFor(Occurrence occurrence) {
        for (Iterator<Ending> all = early.iterator(); all.hasNext(); ) {
            Ending each = all.next();
            if (Rehearsal.isSame(each.ended().occurrence(), occurrence)) {
                all.remove();
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
