package org.evoloop.benchmarks.decision;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.concurrent.TimeUnit;
import org.evoloop.evolution.Decision;
import org.evoloop.evolution.DecisionTable;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.BenchmarkMode;
import org.openjdk.jmh.annotations.Mode;
import org.openjdk.jmh.annotations.OutputTimeUnit;
import org.openjdk.jmh.annotations.Param;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;

/** One event by its number, and the lower limit: a table of numbers and an array of actions. */
@State(Scope.Benchmark)
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.NANOSECONDS)
public class HandleBenchmark {
    @Param({"6", "1000", "10000"})
    public int states = 6;

    private DecisionTable table = EvoloopWalker.table(Walk.robot());
    private int[] way = {};
    private int situation;
    private int position;
    private long actions;

    private int[] targets = {};
    private Runnable[] does = {};
    private int width;
    private int state;
    private long laps;

    @Setup
    public void build() {
        Walk walk = Walk.of(states);
        table = EvoloopWalker.table(walk);
        way = walk.way().stream().mapToInt(table::number).toArray();
        situation = walk.states().contains("Off") ? table.after(table.initial(), "Clean") : table.initial();
        buildLimit(walk);
    }

    private void buildLimit(Walk walk) {
        List<String> events = new ArrayList<>(walk.events());
        events.sort(Comparator.comparingInt(table::number));
        width = events.size();
        targets = new int[walk.states().size() * width];
        does = new Runnable[targets.length];
        for (Walk.Move move : walk.moves()) {
            int cell = walk.states().indexOf(move.source()) * width + table.number(move.event());
            targets[cell] = walk.states().indexOf(move.target());
            does[cell] = () -> actions++;
        }
        state = walk.states().indexOf(walk.initial());
    }

    @Benchmark
    public long byNumber() {
        lap();
        int number = way[position];
        Decision decision = table.decide(situation, number);
        if (!(decision instanceof Decision.NotAcceptable)) {
            situation = table.after(situation, number);
            actions++;
        }
        position = position + 1 == way.length ? 0 : position + 1;
        return actions;
    }

    @Benchmark
    public long intTable() {
        lap();
        int cell = state * width + way[position];
        does[cell].run();
        state = targets[cell];
        position = position + 1 == way.length ? 0 : position + 1;
        return actions;
    }

    private void lap() {
        if (++laps % Library.QUICK_LAP == 0) {
            CpuWindows.SHARED.lap(Library.QUICK_LAP);
        }
    }
}
