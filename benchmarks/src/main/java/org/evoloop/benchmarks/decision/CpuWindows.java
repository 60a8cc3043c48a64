package org.evoloop.benchmarks.decision;

import java.lang.management.ManagementFactory;
import java.lang.management.ThreadMXBean;
import java.util.Collection;
import java.util.List;
import org.openjdk.jmh.infra.BenchmarkParams;
import org.openjdk.jmh.infra.IterationParams;
import org.openjdk.jmh.profile.InternalProfiler;
import org.openjdk.jmh.results.AggregationPolicy;
import org.openjdk.jmh.results.Aggregator;
import org.openjdk.jmh.results.IterationResult;
import org.openjdk.jmh.results.Result;
import org.openjdk.jmh.results.ResultRole;
import org.openjdk.jmh.util.SingletonStatistics;

/**
 * The processor time of one operation, as the fastest of many short windows. On a machine with other load, this value
 * varies least between runs.
 *
 * <p>Threading: written by the benchmark's only thread between two calls of the profiler.
 */
public final class CpuWindows implements InternalProfiler {
    static final CpuWindows SHARED = new CpuWindows();
    static final String LABEL = "cpuMinimum";

    private static final ThreadMXBean THREADS = ManagementFactory.getThreadMXBean();
    /** In shorter windows the cost of reading the clock would dominate. */
    private static final long WINDOW_NANOS = 10_000_000;

    private long begunNanos = -1;
    private long operations;
    private double minimum = Double.POSITIVE_INFINITY;

    /** Reports that the calling thread has done {@code more} operations since the last call. */
    void lap(long more) {
        long now = THREADS.getCurrentThreadCpuTime();
        operations += more;
        long spent = now - begunNanos;
        if (begunNanos < 0) {
            begunNanos = now;
            operations = 0;
        } else if (spent >= WINDOW_NANOS) {
            minimum = Math.min(minimum, (double) spent / operations);
            begunNanos = now;
            operations = 0;
        }
    }

    @Override
    public String getDescription() {
        return "processor time of an operation, minimum over windows";
    }

    @Override
    public void beforeIteration(BenchmarkParams benchmark, IterationParams iteration) {
        SHARED.minimum = Double.POSITIVE_INFINITY;
        SHARED.begunNanos = -1;
    }

    @Override
    public Collection<Minimum> afterIteration(
            BenchmarkParams benchmark, IterationParams iteration, IterationResult result) {
        return Double.isInfinite(SHARED.minimum) ? List.of() : List.of(new Minimum(SHARED.minimum));
    }

    /** A result whose aggregate is the smallest value. */
    static final class Minimum extends Result<Minimum> {
        private static final long serialVersionUID = 1;

        Minimum(double nanos) {
            super(ResultRole.SECONDARY, LABEL, new SingletonStatistics(nanos), "ns/op", AggregationPolicy.MIN);
        }

        @Override
        protected Aggregator<Minimum> getThreadAggregator() {
            return Minimum::smallest;
        }

        @Override
        protected Aggregator<Minimum> getIterationAggregator() {
            return Minimum::smallest;
        }

        private static Minimum smallest(Collection<Minimum> results) {
            return new Minimum(
                    results.stream().mapToDouble(Minimum::getScore).min().orElse(Double.NaN));
        }
    }
}
