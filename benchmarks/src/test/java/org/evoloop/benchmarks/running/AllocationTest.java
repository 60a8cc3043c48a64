package org.evoloop.benchmarks.running;

import static org.assertj.core.api.Assertions.assertThat;

import com.sun.management.ThreadMXBean;
import java.lang.management.ManagementFactory;
import org.junit.jupiter.api.Test;

/** The bytes allocated per event are exact on any machine, however busy. */
class AllocationTest {
    private static final ThreadMXBean THREADS = (ThreadMXBean) ManagementFactory.getThreadMXBean();
    private static final int TIMES = 20_000;

    private interface Work {
        void run() throws InterruptedException;
    }

    private static double bytesEach(Work work) throws InterruptedException {
        // The first rounds fill queues and records that are kept.
        for (int time = 0; time < TIMES; time++) {
            work.run();
        }
        long before = THREADS.getCurrentThreadAllocatedBytes();
        for (int time = 0; time < TIMES; time++) {
            work.run();
        }
        return (double) (THREADS.getCurrentThreadAllocatedBytes() - before) / TIMES;
    }

    @Test
    void aCycleOfTheLoopAllocatesNothing() throws InterruptedException {
        try (SteppedLoop loop = new SteppedLoop()) {
            // Less than one, not zero: reading the counter may itself allocate once.
            assertThat(bytesEach(loop::cycle)).isLessThan(1);
        }
    }

    @Test
    void aConversionAllocatesLittle() throws InterruptedException {
        try (CleaningRobot robot = new CleaningRobot(new PathTimer(), false)) {
            assertThat(bytesEach(robot::next)).isLessThan(450);
            robot.requireAllHandled();
        }
    }
}
