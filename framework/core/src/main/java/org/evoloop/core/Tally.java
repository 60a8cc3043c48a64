package org.evoloop.core;

/**
 * How many occurrences came and what became of them.
 *
 * <p>Threading: immutable.
 *
 * @param observed all that came; the sum of the outcomes, of those refused, and of those that wait or are in progress
 * @param refused those that came, or waited, while the converter was closed
 * @param queued those that had to wait or could begin at once
 * @param highest most that ever waited
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
