package org.evoloop.engine;

import org.evoloop.evolution.Outcome;

/**
 * The number of occurrences and their outcomes. Those observed are the sum of all outcomes, of those refused, and of
 * those that wait or are in progress.
 */
final class Counts {
    private final long[] outcomes = new long[Outcome.values().length];
    private long observed;
    private long refused;
    private long queued;
    private int highest;

    Counts(Tally tally) {
        restore(tally);
    }

    void restore(Tally tally) {
        outcomes[placeOf(Outcome.HANDLED)] = tally.handled();
        outcomes[placeOf(Outcome.IGNORED)] = tally.ignored();
        outcomes[placeOf(Outcome.STALE)] = tally.stale();
        outcomes[placeOf(Outcome.FAILED)] = tally.failed();
        outcomes[placeOf(Outcome.DROPPED)] = tally.dropped();
        observed = tally.observed();
        refused = tally.refused();
        queued = tally.queued();
        highest = tally.highest();
    }

    /** Counts an occurrence and returns its number. */
    long observe() {
        return ++observed;
    }

    void refuse() {
        refused++;
    }

    void queued(int waiting) {
        queued++;
        highest(waiting);
    }

    void highest(int waiting) {
        highest = Math.max(highest, waiting);
    }

    void end(Outcome outcome) {
        outcomes[placeOf(outcome == Outcome.OVERTAKEN ? Outcome.FAILED : outcome)]++;
    }

    Tally tally() {
        return new Tally(
                observed,
                outcomes[placeOf(Outcome.HANDLED)],
                outcomes[placeOf(Outcome.IGNORED)],
                outcomes[placeOf(Outcome.STALE)],
                outcomes[placeOf(Outcome.FAILED)],
                outcomes[placeOf(Outcome.DROPPED)],
                refused,
                queued,
                highest);
    }

    @SuppressWarnings("EnumOrdinal") // a map would box a number in every event
    private static int placeOf(Outcome outcome) {
        return outcome.ordinal();
    }
}
