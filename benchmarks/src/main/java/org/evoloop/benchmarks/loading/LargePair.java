package org.evoloop.benchmarks.loading;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import org.evoloop.evolution.DecisionTable;

/** A pair of 10,000 states and 100,000 transitions, in SCXML: from the files to the decisions, again and again. */
public final class LargePair {
    private static final int STATES = 10_000;
    private static final int EVENTS = 5;

    private LargePair() {}

    /**
     * Prints the median of the times in ms after a few to warm up.
     *
     * @param arguments how many times
     */
    public static void main(String[] arguments) throws IOException {
        int times = Integer.parseInt(arguments[0]);
        Path original = Files.createTempFile("evoloop", ".scxml");
        Path evolved = Files.createTempFile("evoloop", ".scxml");
        try {
            Files.writeString(original, chart());
            Files.writeString(evolved, chart());
            double[] millis = new double[times];
            for (int time = -times; time < times; time++) {
                long begun = System.nanoTime();
                DecisionTable table = ReadPair.compile(original, evolved);
                if (table.configurations().size() != STATES) {
                    throw new IllegalStateException(
                            "only " + table.configurations().size() + " configurations were compiled");
                }
                if (time >= 0) {
                    millis[time] = (System.nanoTime() - begun) / 1e6;
                }
            }
            Arrays.sort(millis);
            System.out.println("large " + millis[times / 2]);
        } finally {
            Files.delete(original);
            Files.delete(evolved);
        }
    }

    /** A state has five ways out, near and far. */
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
