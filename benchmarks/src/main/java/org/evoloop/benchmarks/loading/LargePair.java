package org.evoloop.benchmarks.loading;

import java.io.IOException;
import java.lang.management.ManagementFactory;
import java.lang.management.ThreadMXBean;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Map;
import org.evoloop.benchmarks.report.Figures;
import org.evoloop.benchmarks.report.Row;
import org.evoloop.evolution.DecisionTable;

/**
 * A pair of models with 10,000 states and 100,000 transitions, in SCXML. Repeatedly reads the files and compiles the
 * decisions, alternating with a StAX parse of the same two files.
 */
public final class LargePair {
    private static final int STATES = 10_000;
    private static final int EVENTS = 5;
    private static final double MOST = 3;
    private static final ThreadMXBean THREADS = ManagementFactory.getThreadMXBean();

    private LargePair() {}

    /**
     * Prints, after as many warm-up turns, the minimum processor time of the thread in ms, of both, and the median of
     * our wall time.
     *
     * @param arguments the number of turns
     */
    public static void main(String[] arguments) throws IOException {
        int turns = Integer.parseInt(arguments[0]);
        Path original = Files.createTempFile("evoloop", ".scxml");
        Path evolved = Files.createTempFile("evoloop", ".scxml");
        try {
            Files.writeString(original, chart());
            Files.writeString(evolved, chart());
            double parsed = Double.POSITIVE_INFINITY;
            double compiled = Double.POSITIVE_INFINITY;
            double[] clock = new double[turns];
            for (int turn = -turns; turn < turns; turn++) {
                long begun = THREADS.getCurrentThreadCpuTime();
                parse(original, evolved);
                long between = THREADS.getCurrentThreadCpuTime();
                long clockBegun = System.nanoTime();
                compile(original, evolved);
                if (turn >= 0) {
                    clock[turn] = (System.nanoTime() - clockBegun) / 1e6;
                    parsed = Math.min(parsed, (between - begun) / 1e6);
                    compiled = Math.min(compiled, (THREADS.getCurrentThreadCpuTime() - between) / 1e6);
                }
            }
            Arrays.sort(clock);
            System.out.println("large " + compiled);
            System.out.println("stax " + parsed);
            System.out.println("large clock " + clock[turns / 2]);
        } finally {
            Files.delete(original);
            Files.delete(evolved);
        }
    }

    private static void parse(Path original, Path evolved) throws IOException {
        if (ParseStax.characters(original) != ParseStax.characters(evolved)) {
            throw new IllegalStateException("one of two equal files was not read to its end");
        }
    }

    private static void compile(Path original, Path evolved) {
        DecisionTable table = ReadPair.compile(original, evolved);
        if (table.configurations().size() != STATES) {
            throw new IllegalStateException("only " + table.configurations().size() + " configurations were compiled");
        }
    }

    /** @param found the printed figures */
    static Row row(Figures found) {
        return new Row(
                "10,000 states, 100,000 transitions, processor time",
                "ms",
                found.get("large"),
                Row.Goal.atMostTimes(MOST, "StAX parse", found.get("stax")),
                Map.of("by the clock, with the collector", found.get("large clock")));
    }

    /** Each state has five outgoing transitions, to near and far states. */
    private static String chart() {
        StringBuilder text =
                new StringBuilder("<scxml xmlns=\"http://www.w3.org/2005/07/scxml\" version=\"1.0\" initial=\"s0\">\n");
        for (int state = 0; state < STATES; state++) {
            text.append("<state id=\"s").append(state).append("\">\n");
            for (int event = 0; event < EVENTS; event++) {
                int target = (state * (event + 1) + 1) % STATES;
                text.append("<transition event=\"e")
                        .append(event)
                        .append("\" target=\"s")
                        .append(target)
                        .append("\"/>\n");
            }
            text.append("</state>\n");
        }
        return text.append("</scxml>\n").toString();
    }
}
