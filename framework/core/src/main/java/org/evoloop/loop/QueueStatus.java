package org.evoloop.loop;

/**
 * The status of the queue before the loop.
 *
 * <p>Threading: immutable; a snapshot of one moment.
 *
 * @param depth how many occurrences wait in all
 * @param capacity how many may wait of those that may be lost; in a converter, of controllers' events
 * @param highest the most that have ever waited at once
 * @param taken how many have been queued
 * @param dropped how many were lost because the queue was full
 * @param refused how many came while the loop was closed, or still waited when it closed
 * @since 0.1
 */
public record QueueStatus(int depth, int capacity, int highest, long taken, long dropped, long refused) {}
