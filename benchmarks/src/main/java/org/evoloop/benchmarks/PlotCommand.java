package org.evoloop.benchmarks;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.concurrent.Callable;
import org.evoloop.benchmarks.drawing.SpeedPlot;
import org.evoloop.benchmarks.report.Results;
import picocli.CommandLine;
import picocli.CommandLine.Command;
import picocli.CommandLine.Parameters;

/** Plots the results of a run. */
@Command(
        name = "plot",
        description = "Draws the results that a run has written with --json, as SVG.",
        mixinStandardHelpOptions = true)
final class PlotCommand implements Callable<Integer> {
    @Parameters(index = "0", paramLabel = "RESULTS", description = "A file under benchmarks/results.")
    private Path results = Path.of("");

    @Parameters(index = "1", paramLabel = "PICTURE", description = "The SVG file that is written.")
    private Path picture = Path.of("");

    @Override
    public Integer call() {
        String svg = SpeedPlot.svg(Results.read(results));
        try {
            Files.writeString(picture, svg);
        } catch (IOException cause) {
            throw new IllegalArgumentException(
                    "cannot write " + picture + "; name a file in a directory that exists", cause);
        }
        return CommandLine.ExitCode.OK;
    }
}
