package org.evoloop.benchmarks;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.Callable;
import org.evoloop.benchmarks.drawing.SoakPlot;
import org.evoloop.benchmarks.report.Origin;
import org.evoloop.benchmarks.report.SoakResults;
import org.evoloop.benchmarks.report.SoakSample;
import org.evoloop.benchmarks.report.TemporaryFolder;
import org.evoloop.benchmarks.running.Soak;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;

/** Runs a converter for a long time and checks whether its resource usage grows. */
@Command(
        name = "soak",
        description = "Converts events with a journal for a long time; fails if heap, threads, open files or disk "
                + "usage grow.",
        mixinStandardHelpOptions = true)
final class SoakCommand implements Callable<Integer> {
    private static final int LOOKS = 60;
    private static final long LEAST = 1000;

    @Option(names = "--events", paramLabel = "N", description = "How many events, at least 1000 (default: 10000000).")
    private long events = 10_000_000;

    @Option(names = "--stepped", description = "Without threads in the loop, which is many times as fast.")
    private boolean stepped;

    @Option(names = "--json", paramLabel = "FILE", description = "Writes the figures to FILE as well.")
    private @Nullable Path json;

    @Option(names = "--plot", paramLabel = "FILE", description = "Draws the figures into FILE, as SVG.")
    private @Nullable Path plot;

    @Override
    public Integer call() throws Exception {
        if (events < LEAST) {
            throw new IllegalArgumentException("--events is " + events + ", allowed is " + LEAST + " and more");
        }
        if (json != null) {
            Main.requireWritable("--json", json);
        }
        if (plot != null) {
            Main.requireWritable("--plot", plot);
        }
        Origin origin = Origin.here();
        SoakResults results = new SoakResults(origin.machine(), origin.commit(), origin.day(), run());
        if (json != null) {
            Files.writeString(json, results.json());
        }
        if (plot != null) {
            Files.writeString(plot, SoakPlot.svg(results));
        }
        System.out.println(results.samples().get(0));
        System.out.println(results.samples().get(LOOKS - 1));
        System.out.println(results.machine());
        List<String> grown = results.grown();
        grown.forEach(line -> System.out.println("grown: " + line));
        return grown.isEmpty() ? CommandLine.ExitCode.OK : CommandLine.ExitCode.SOFTWARE;
    }

    private List<SoakSample> run() throws IOException, InterruptedException {
        try (TemporaryFolder journal = TemporaryFolder.create()) {
            return new Soak(journal.path(), !stepped).run(events, LOOKS);
        }
    }
}
