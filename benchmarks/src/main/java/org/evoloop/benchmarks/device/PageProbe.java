package org.evoloop.benchmarks.device;

import java.nio.ByteBuffer;

/**
 * Tells whether the computer takes memory away from a program that pauses, as the hosts of some virtual machines do:
 * whatever code runs after a pause then waits for its memory, the longer the more code and data it has.
 */
final class PageProbe {
    private static final int PAGES = 256;
    private static final int PAGE_BYTES = 4_096;

    /** A page that is there takes less than a microsecond, even if it is in no cache. */
    private static final long SLOW_NANOS = 20_000;

    private final ByteBuffer memory = ByteBuffer.allocateDirect(PAGES * PAGE_BYTES);
    private long touched;
    private long slow;

    /** Touches all pages. The first call is not counted, since the system gives a program its memory only then. */
    void touch() {
        boolean counted = memory.get(0) != 0;
        for (int page = 0; page < PAGES; page++) {
            long begun = System.nanoTime();
            memory.put(page * PAGE_BYTES, (byte) 1);
            if (counted) {
                touched++;
                slow += System.nanoTime() - begun > SLOW_NANOS ? 1 : 0;
            }
        }
    }

    /** How many of the pages had to be waited for, in percent. */
    double slowPercent() {
        return touched == 0 ? 0 : 100.0 * slow / touched;
    }
}
