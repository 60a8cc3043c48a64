package org.evoloop.engine;

/**
 * The number of occurrences and their outcomes.
 *
 * <p>Threading: immutable.
 *
 * @param observed all occurrences; the sum of the outcomes, of those refused, and of those that wait or are in progress
 * @param refused those that came, or waited, while the converter was closed
 * @param queued those that were accepted, whether they had to wait or began at once
 * @param highest the most that ever waited
 * @since 0.1
 */
public record Tally(
        long observed,
        long handled,
        long ignored,
        long stale,
        long failed,
        long dropped,
        long refused,
        long queued,
        int highest) {}
