package org.evoloop.benchmarks.running;

import static org.assertj.core.api.Assertions.assertThat;

import com.sun.management.ThreadMXBean;
import java.lang.management.ManagementFactory;
import org.junit.jupiter.api.Test;

/** What is allocated on the way of an event is exact on any machine, busy or not. */
class AllocationTest {
    private static final ThreadMXBean THREADS = (ThreadMXBean) ManagementFactory.getThreadMXBean();
    private static final int TIMES = 20_000;

    private interface Work {
        void run() throws InterruptedException;
    }

    private static double bytesEach(Work work) throws InterruptedException {
        // The first rounds fill queues and books that stay.
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
            // Less than one: the reading of the counter itself may cost something once.
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
