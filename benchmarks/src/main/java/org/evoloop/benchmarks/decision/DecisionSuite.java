package org.evoloop.benchmarks.decision;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.evoloop.benchmarks.report.Row;
import org.evoloop.benchmarks.report.Suite;
import org.openjdk.jmh.profile.GCProfiler;
import org.openjdk.jmh.results.Result;
import org.openjdk.jmh.results.RunResult;
import org.openjdk.jmh.runner.Runner;
import org.openjdk.jmh.runner.format.OutputFormatFactory;
import org.openjdk.jmh.runner.options.OptionsBuilder;
import org.openjdk.jmh.runner.options.TimeValue;
import org.openjdk.jmh.runner.options.VerboseMode;

/**
 * A decision by name and by number, compared with the libraries and with the lower limit; processor time, minimum over
 * windows.
 */
public final class DecisionSuite implements Suite {
    private static final String BY_NAME = "byName";
    private static final String BYTES = "gc.alloc.rate.norm";

    private final Map<String, Map<String, Result<?>>> found = new LinkedHashMap<>();

    @Override
    public String name() {
        return "decision";
    }

    @Override
    public List<Row> measure(boolean quick) throws Exception {
        OptionsBuilder options = new OptionsBuilder();
        options.include(DecisionSuite.class.getPackageName())
                .addProfiler(GCProfiler.class)
                .addProfiler(CpuWindows.class)
                .forks(1)
                .warmupIterations(2)
                .warmupTime(TimeValue.milliseconds(quick ? 500 : 2000))
                .measurementIterations(3)
                .measurementTime(TimeValue.milliseconds(quick ? 500 : 2000))
                .timeout(TimeValue.minutes(2))
                .shouldFailOnError(true);
        if (quick) {
            options.param("states", "6", "10000");
        }
        for (RunResult result : new Runner(
                        options.build(), OutputFormatFactory.createFormatInstance(System.err, VerboseMode.NORMAL))
                .run()) {
            Map<String, Result<?>> byLabel = new LinkedHashMap<>();
            result.getSecondaryResults().forEach(byLabel::put);
            found.put(key(result), byLabel);
        }
        return List.of(
                new Row(
                        "a decision by the event's name",
                        "ns",
                        nanos(Library.EVOLOOP, 6),
                        Row.Goal.atMostTimes(0.4, Library.STATELESS4J.label(), nanos(Library.STATELESS4J, 6)),
                        peers(6)),
                new Row("the same, allocated", "B", Math.rint(bytes(Library.EVOLOOP)), Row.Goal.atMost(0)),
                new Row(
                        "a decision by the event's number",
                        "ns",
                        score("byNumber 6", CpuWindows.LABEL),
                        Row.Goal.atMostTimes(2, "table of ints", score("intTable 6", CpuWindows.LABEL))),
                new Row(
                        "a decision among 10,000 states",
                        "ns",
                        nanos(Library.EVOLOOP, 10_000),
                        Row.Goal.atMostTimes(2, "among 6", nanos(Library.EVOLOOP, 6)),
                        peers(10_000)));
    }

    private static String key(RunResult result) {
        String benchmark = result.getParams().getBenchmark();
        String library = result.getParams().getParam("library");
        return benchmark.substring(benchmark.lastIndexOf('.') + 1) + (library == null ? "" : " " + library) + " "
                + result.getParams().getParam("states");
    }

    private Map<String, Double> peers(int states) {
        Map<String, Double> peers = new LinkedHashMap<>();
        for (Library library : Library.values()) {
            if (library != Library.EVOLOOP) {
                peers.put(library.label(), nanos(library, states));
            }
        }
        return peers;
    }

    private double nanos(Library library, int states) {
        return score(BY_NAME + " " + library + " " + states, CpuWindows.LABEL);
    }

    private double bytes(Library library) {
        return score(BY_NAME + " " + library + " 6", BYTES);
    }

    private double score(String key, String label) {
        Result<?> result = found.getOrDefault(key, Map.of()).get(label);
        if (result == null) {
            throw new IllegalStateException("nothing was measured for " + key + " " + label);
        }
        return result.getScore();
    }
}
