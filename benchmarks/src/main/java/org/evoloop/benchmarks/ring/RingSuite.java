package org.evoloop.benchmarks.ring;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.EnumMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.HdrHistogram.Histogram;
import org.evoloop.benchmarks.report.Figures;
import org.evoloop.benchmarks.report.Fork;
import org.evoloop.benchmarks.report.Row;
import org.evoloop.benchmarks.report.Suite;

/**
 * The loop with a thread per component, and bare rings, alternating in one process. The result is the median of several
 * turns: whether the scheduler puts the threads of a ring on one processor or on two changes the time by a factor of
 * three, and varies randomly.
 */
public final class RingSuite implements Suite {
    private static final int LOOP_WARM_UP = 30_000;
    private static final String LOOP = "loop";

    @Override
    public String name() {
        return "ring";
    }

    @Override
    public List<Row> measure(boolean quick) throws Exception {
        Figures found = Fork.of(RingSuite.class, List.of(), quick ? "3" : "9", quick ? "20000" : "60000")
                .figures();
        Map<String, Double> p50 = new LinkedHashMap<>();
        Map<String, Double> p99 = new LinkedHashMap<>();
        for (HandOff.Kind kind : HandOff.Kind.values()) {
            p50.put(kind.label(), found.get(kind + " p50"));
            p99.put(kind.label(), found.get(kind + " p99"));
        }
        return List.of(
                row("the whole loop, 4 threads, median", found.get(LOOP + " p50"), 1.3, p50),
                row("the whole loop, 4 threads, 99th percentile", found.get(LOOP + " p99"), 1.5, p99),
                new Row(
                        "the whole loop, 4 threads, allocated a cycle",
                        "B",
                        Math.rint(found.get(LOOP + " bytes")),
                        Row.Goal.atMost(0)),
                FloodTurns.row(
                        Fork.of(FloodTurns.class, List.of(), quick ? "3" : "7").figures()));
    }

    private static Row row(String what, double ours, double bound, Map<String, Double> rings) {
        Map.Entry<String, Double> best =
                rings.entrySet().stream().min(Map.Entry.comparingByValue()).orElseThrow();
        return new Row(what, "us", ours, Row.Goal.atMostTimes(bound, best.getKey(), best.getValue()), rings);
    }

    /**
     * Prints the results, in microseconds and bytes.
     *
     * @param arguments the number of turns, and the number of rounds in each; a bare ring warms up for half as many
     */
    public static void main(String[] arguments) throws InterruptedException {
        int turns = Integer.parseInt(arguments[0]);
        int rounds = Integer.parseInt(arguments[1]);
        Map<HandOff.Kind, List<Histogram>> rings = new EnumMap<>(HandOff.Kind.class);
        List<Histogram> loops = new ArrayList<>();
        double bytes = 0;
        for (int turn = 0; turn < turns; turn++) {
            for (HandOff.Kind kind : HandOff.Kind.values()) {
                rings.computeIfAbsent(kind, key -> new ArrayList<>()).add(BareRing.run(kind, rounds / 2, rounds));
            }
            LoopRing.Result loop = LoopRing.run(LOOP_WARM_UP, rounds);
            loops.add(loop.nanos());
            bytes = loop.bytesPerRound();
        }
        rings.forEach((kind, measured) -> print(kind.toString(), measured));
        print(LOOP, loops);
        System.out.println(LOOP + " bytes " + bytes);
    }

    private static void print(String name, List<Histogram> turns) {
        System.out.println(name + " p50 " + median(turns, 50));
        System.out.println(name + " p99 " + median(turns, 99));
    }

    private static double median(List<Histogram> turns, double percentile) {
        double[] sorted = turns.stream()
                .mapToDouble(turn -> turn.getValueAtPercentile(percentile) / 1e3)
                .toArray();
        Arrays.sort(sorted);
        return sorted[sorted.length / 2];
    }
}
