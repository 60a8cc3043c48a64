package org.evoloop.benchmarks.device;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.evoloop.benchmarks.report.Figures;
import org.evoloop.benchmarks.report.Row;
import org.evoloop.loop.LoopConfig;
import org.evoloop.loop.ThreadingModel;

/**
 * A path of a button press through the loop's components, and its limits relative to the most similar bare path over
 * the same link. The limits are ratios within one run, since absolute times depend on the machine's threads.
 */
enum PressWay {
    /** One thread runs all components. */
    CARRIER(
            "button to command, added by us, median",
            "button to command, added by us, 99th percentile",
            ThreadingModel.SINGLE_CARRIER,
            Bare.DIRECT,
            6,
            6),
    /** One thread per component, as in the paper. */
    THREADS(
            "button to command, a thread a component, median",
            "button to command, a thread a component, 99th percentile",
            ThreadingModel.THREAD_PER_COMPONENT,
            Bare.THREADS,
            1.25,
            1.5);

    private final String median;
    private final String percentile99;
    private final ThreadingModel threading;
    private final Bare bare;
    private final double mostAtMedian;
    private final double mostAtPercentile99;

    /** @param median the name of its row; likewise for the 99th percentile */
    PressWay(
            String median,
            String percentile99,
            ThreadingModel threading,
            Bare bare,
            double mostAtMedian,
            double mostAtPercentile99) {
        this.median = median;
        this.percentile99 = percentile99;
        this.threading = threading;
        this.bare = bare;
        this.mostAtMedian = mostAtMedian;
        this.mostAtPercentile99 = mostAtPercentile99;
    }

    /** A path that {@link BareChain} measures. */
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
        return defaults.withThreading(threading);
    }

    /**
     * The rows for its median and its 99th percentile.
     *
     * @param press the output of {@link PressToCommand}
     * @param measured the output of {@link BareChain}
     */
    List<Row> rows(Figures press, Figures measured) {
        return List.of(
                row(median, "p50", mostAtMedian, press, measured),
                row(percentile99, "p99", mostAtPercentile99, press, measured));
    }

    private Row row(String what, String percentile, double most, Figures press, Figures measured) {
        Map<String, Double> others = new LinkedHashMap<>();
        for (Bare way : Bare.values()) {
            others.put(way.label, way.at(percentile, measured));
        }
        return new Row(
                what,
                "us",
                press.get("press " + percentile),
                Row.Goal.atMostTimes(most, bare.label, bare.at(percentile, measured)),
                others);
    }
}
