package org.evoloop.benchmarks.running;

import com.sun.management.ThreadMXBean;
import java.lang.management.ManagementFactory;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import org.evoloop.benchmarks.report.Figures;
import org.evoloop.benchmarks.report.Fork;
import org.evoloop.benchmarks.report.Latencies;
import org.evoloop.benchmarks.report.Row;
import org.evoloop.benchmarks.report.Suite;
import org.evoloop.time.SystemClock;

/** The loop in steps, flooded and idle, and the whole converter of the paper's cleaning robot. */
public final class RunningSuite implements Suite {
    private static final int STEPS = 100_000;
    private static final ThreadMXBean THREADS = (ThreadMXBean) ManagementFactory.getThreadMXBean();

    @Override
    public String name() {
        return "running";
    }

    @Override
    public List<Row> measure(boolean quick) throws Exception {
        Figures found =
                Fork.of(RunningSuite.class, List.of(), quick ? "1" : "6").figures();
        Figures page = Fork.of(PageCost.class, List.of(), quick ? "4" : "20").figures();
        Figures evolve = Fork.of(EvolvePause.class, Fork.SHIPPED_OPTIONS, quick ? "200" : "1000")
                .figures();
        return List.of(
                new Row("the loop without threads, a cycle", "us", found.get("step"), Row.Goal.atMost(0.2)),
                new Row("the same, allocated", "B", Math.rint(found.get("step bytes")), Row.Goal.atMost(0)),
                new Row(
                        "a whole conversion without threads",
                        "us",
                        found.get("conversion"),
                        Row.Goal.atMost(1),
                        Map.of("bytes", found.get("conversion bytes"))),
                new Row(
                        "a whole conversion with threads, median",
                        "us",
                        found.get("path p50"),
                        Row.Goal.atMost(100),
                        Map.of("p99", found.get("path p99"))),
                new Row(
                        "a conversion every 2 ms with 5 viewers of the page and 2 who take nothing, median",
                        "us",
                        page.get("VIEWERS p50"),
                        Row.Goal.atMostTimes(1.25, "without a page", page.get("NONE p50")),
                        Map.of("p99", page.get("VIEWERS p99"), "p99 without", page.get("NONE p99"))),
                new Row(
                        "the same without pauses",
                        "us",
                        page.get("FAST VIEWERS p50"),
                        Row.Goal.atMostTimes(2, "without a page", page.get("FAST NONE p50")),
                        Map.of(
                                "with a listener only",
                                page.get("FAST LISTENER p50"),
                                "events it missed",
                                page.get("FAST LISTENER missed"))),
                pause("the pause when other models of 10,000 states take over, 99th percentile", "PLAIN", evolve),
                pause("the same with a journal", "JOURNAL", evolve),
                new Row("flood of 4 monitors, in steps", "events/s", found.get("flood step"), Row.Goal.least(1e6)),
                new Row("an idle minute's processor time", "ms", found.get("idle"), Row.Goal.atMost(10)));
    }

    private static Row pause(String what, String kind, Figures evolve) {
        return new Row(
                what,
                "us",
                evolve.get(kind + " p99"),
                Row.Goal.atMost(1000),
                Map.of("median", evolve.get(kind + " p50")));
    }

    /**
     * Prints the results.
     *
     * @param arguments how long the idle converter is watched, in units of ten seconds
     */
    public static void main(String[] arguments) throws InterruptedException {
        steps();
        conversions();
        try (FloodedLoop warmUp = new FloodedLoop(false)) {
            warmUp.inSteps(2_000_000);
        }
        try (FloodedLoop flood = new FloodedLoop(false)) {
            System.out.println("flood step " + flood.inSteps(5_000_000));
        }
        idle(Integer.parseInt(arguments[0]));
    }

    private interface Work {
        void run() throws InterruptedException;
    }

    /** The processor time in microseconds and the bytes of one piece of work, from the fastest of many windows. */
    private static void measure(String name, Work work, int pieces) throws InterruptedException {
        double best = Double.POSITIVE_INFINITY;
        double bytes = 0;
        for (int window = 0; window < 60; window++) {
            long begun = THREADS.getCurrentThreadCpuTime();
            long before = THREADS.getCurrentThreadAllocatedBytes();
            for (int piece = 0; piece < pieces; piece++) {
                work.run();
            }
            bytes = (double) (THREADS.getCurrentThreadAllocatedBytes() - before) / pieces;
            best = Math.min(best, (double) (THREADS.getCurrentThreadCpuTime() - begun) / pieces);
        }
        System.out.println(name + " " + best / 1e3);
        System.out.println(name + " bytes " + bytes);
    }

    private static void steps() throws InterruptedException {
        try (SteppedLoop loop = new SteppedLoop()) {
            measure("step", loop::cycle, STEPS);
            if (loop.executed() != 60L * STEPS) {
                throw new IllegalStateException("not every cycle came to its end");
            }
        }
    }

    private static void conversions() throws InterruptedException {
        PathTimer timer = new PathTimer();
        try (CleaningRobot robot = new CleaningRobot(timer, false)) {
            measure("conversion", robot::next, STEPS / 10);
            robot.requireAllHandled();
        }
        try (CleaningRobot robot = new CleaningRobot(timer, true)) {
            for (int event = 0; event < STEPS; event++) {
                robot.next();
            }
            timer.clear();
            for (int event = 0; event < STEPS; event++) {
                robot.next();
            }
            robot.requireAllHandled();
        }
        Latencies.print("path", timer.nanos());
    }

    /**
     * The processor time of all Java threads per minute in which a converter with threads waits for events. The virtual
     * machine's own work, which does not depend on the program, is not included.
     */
    private static void idle(int tenSeconds) throws InterruptedException {
        try (CleaningRobot robot = new CleaningRobot(new PathTimer(), true);
                SystemClock clock = new SystemClock()) {
            robot.next();
            clock.sleep(Duration.ofSeconds(1));
            long before = threadNanos();
            clock.sleep(Duration.ofSeconds(10L * tenSeconds));
            System.out.println("idle " + (threadNanos() - before) / 1e6 * 6 / tenSeconds);
        }
    }

    private static long threadNanos() {
        long sum = 0;
        for (long id : THREADS.getAllThreadIds()) {
            sum += Math.max(0, THREADS.getThreadCpuTime(id));
        }
        return sum;
    }
}
