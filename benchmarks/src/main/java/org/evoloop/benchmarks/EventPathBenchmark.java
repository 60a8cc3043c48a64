package org.evoloop.benchmarks;

import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.LockSupport;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.BenchmarkMode;
import org.openjdk.jmh.annotations.Mode;
import org.openjdk.jmh.annotations.OutputTimeUnit;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.State;
import org.openjdk.jmh.annotations.TearDown;

/**
 * One event on its way through the loop. What counts is what {@link EventPathProfiler} adds to the results; JMH's own
 * time is that of the whole operation, with the wait for the next event.
 */
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.MICROSECONDS)
public class EventPathBenchmark {
    private static final long PAUSE_NANOS = 1_000_000;

    /** A converter with threads. */
    @State(Scope.Benchmark)
    public static class Threaded {
        final CleaningRobot robot = new CleaningRobot(PathTimer.SHARED, true);

        @TearDown
        public void close() {
            finish(robot);
        }
    }

    /** A converter without threads. */
    @State(Scope.Benchmark)
    public static class Stepped {
        final CleaningRobot robot = new CleaningRobot(PathTimer.SHARED, false);

        @TearDown
        public void close() {
            finish(robot);
        }
    }

    private static void finish(CleaningRobot robot) {
        robot.requireAllHandled();
        robot.close();
    }

    /** Events as people make them: every thread of the loop has gone to sleep meanwhile. */
    @Benchmark
    public void threadsAfterPause(Threaded converter) throws InterruptedException {
        LockSupport.parkNanos(PAUSE_NANOS);
        converter.robot.next();
    }

    /** One event right after the other. */
    @Benchmark
    public void threadsBackToBack(Threaded converter) throws InterruptedException {
        converter.robot.next();
    }

    /** One event right after the other, each observed and stepped on the caller's thread. */
    @Benchmark
    public void withoutThreads(Stepped converter) throws InterruptedException {
        converter.robot.next();
    }
}
