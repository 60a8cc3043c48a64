package org.evoloop.loop;

/**
 * How a thread of the loop waits for its turn: it checks a few times, then yields to other threads a few times, then
 * sleeps until it is woken. Checking and yielding cost processor time; waking a sleeping thread costs time in the
 * thread that wakes it, and adds delay. A thread that has just slept for long sleeps at once the next time: where
 * little happens, staying awake does not help, and a thread that yields to busy ones (image processing, for example)
 * gets the processor back late.
 *
 * <p>Threading: immutable.
 *
 * @param looks how often a thread checks for its turn without yielding, 0 to 10,000; more than a few slow down two
 *     processors
 * @param yields how often it yields before it sleeps, 0 to 10,000
 * @since 0.1
 */
public record WaitStrategy(int looks, int yields) {
    /** A thread woken within this time does not sleep at once the next time. */
    static final long SOON_NANOS = 200_000;

    /** Sleeps at once: the least processor time. */
    public static final WaitStrategy PARK = new WaitStrategy(0, 0);

    /**
     * Yields first: on few processors, the thread that has the turn then runs at once, and the next one is still awake
     * when its turn comes. The fastest strategy measured, see {@code docs/performance.md}.
     */
    public static final WaitStrategy YIELD_THEN_PARK = new WaitStrategy(0, 30);

    /** For logs and tables: {@code look 0, yield 30, park}. */
    @Override
    public String toString() {
        return "look " + looks + ", yield " + yields + ", park";
    }
}
