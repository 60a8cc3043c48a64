package org.evoloop.benchmarks.device;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.UnaryOperator;
import org.evoloop.benchmarks.report.Figures;
import org.evoloop.benchmarks.report.Row;
import org.evoloop.loop.LoopConfig;

/**
 * How a press goes through the loop's components, and what it may cost beside the bare way over the same link that is most
 * like it: ratios in one run, since the time itself is that of the machine's threads.
 */
enum PressWay {
    /** A thread a component, as in the paper. */
    THREADS("added by us", config -> config, Bare.THREADS, 1.25, 1.5);

    private final String label;

    @SuppressWarnings("ImmutableEnumChecker") // functions that hold nothing
    private final UnaryOperator<LoopConfig> config;

    private final Bare bare;
    private final double mostAtMedian;
    private final double mostAtPercentile99;

    PressWay(
            String label, UnaryOperator<LoopConfig> config, Bare bare, double mostAtMedian, double mostAtPercentile99) {
        this.label = label;
        this.config = config;
        this.bare = bare;
        this.mostAtMedian = mostAtMedian;
        this.mostAtPercentile99 = mostAtPercentile99;
    }

    /** A way that {@link BareChain} measures. */
    enum Bare {
        DIRECT("direct", "a byte sent back by its reader"),
        THREADS("threads", "by way of 3 bare threads");

        private final String figure;
        private final String label;

        Bare(String figure, String label) {
            this.figure = figure;
            this.label = label;
        }

        double at(String percentile, Figures bare) {
            return bare.get(figure + " " + percentile);
        }
    }

    LoopConfig configured(LoopConfig defaults) {
        return config.apply(defaults);
    }

    /**
     * Its median and its 99th percentile.
     *
     * @param press what {@link PressToCommand} has told
     * @param measured what {@link BareChain} has told
     */
    List<Row> rows(Figures press, Figures measured) {
        return List.of(
                row("median", "p50", mostAtMedian, press, measured),
                row("99th percentile", "p99", mostAtPercentile99, press, measured));
    }

    private Row row(String what, String percentile, double most, Figures press, Figures measured) {
        Map<String, Double> others = new LinkedHashMap<>();
        for (Bare way : Bare.values()) {
            others.put(way.label, way.at(percentile, measured));
        }
        return new Row(
                "button to command, " + label + ", " + what,
                "us",
                press.get("press " + percentile),
                Row.Goal.atMostTimes(most, bare.label, bare.at(percentile, measured)),
                others);
    }
}
