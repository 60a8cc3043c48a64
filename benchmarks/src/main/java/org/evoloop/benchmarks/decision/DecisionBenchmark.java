package org.evoloop.benchmarks.decision;

import java.util.concurrent.TimeUnit;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.BenchmarkMode;
import org.openjdk.jmh.annotations.Mode;
import org.openjdk.jmh.annotations.OutputTimeUnit;
import org.openjdk.jmh.annotations.Param;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;
import org.openjdk.jmh.annotations.TearDown;

/**
 * One event, by its name, through the public interface of a library. Ours decides what the event means for a pair of
 * models, the others take a transition of one model. The relevant figure is that of {@link CpuWindows}; JMH's own is
 * wall time.
 */
@State(Scope.Benchmark)
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.NANOSECONDS)
public class DecisionBenchmark {
    @Param({"EVOLOOP", "STATELESS4J", "COLA", "SQUIRREL", "COMMONS_SCXML", "SPRING", "HASH_MAP"})
    public Library library = Library.EVOLOOP;

    @Param({"6", "1000", "10000"})
    public int states = 6;

    private Walk walk = Walk.robot();
    private String[] way = {};
    private Walker walker = new HashMapWalker(walk);
    private long fired;
    private int position;

    @Setup
    public void build() {
        walk = Walk.of(states);
        way = walk.way().toArray(String[]::new);
        walker = library.walk(walk);
        fired = walker.actions();
    }

    @Benchmark
    public long byName() {
        if (fired % library.lap() == 0) {
            CpuWindows.SHARED.lap(library.lap());
        }
        walker.fire(way[position]);
        position = position + 1 == way.length ? 0 : position + 1;
        fired++;
        return walker.actions();
    }

    /**
     * Fails if any event took no transition, since its time would be meaningless.
     *
     * @throws IllegalStateException if so
     */
    @TearDown
    public void requireAllTaken() {
        if (walker.actions() != fired) {
            throw new IllegalStateException(
                    library + " took " + walker.actions() + " transitions on " + fired + " events");
        }
    }
}
