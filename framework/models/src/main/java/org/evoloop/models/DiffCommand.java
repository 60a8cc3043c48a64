package org.evoloop.models;

import java.util.List;
import java.util.concurrent.Callable;
import org.evoloop.evolution.ModelPair;
import org.evoloop.models.diagram.SvgWriter;
import org.evoloop.models.evolution.DifferenceDiagram;
import org.evoloop.models.evolution.DifferenceJson;
import org.evoloop.models.evolution.DifferenceText;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Spec;

/** Compares two models. */
@Command(
        name = "diff",
        description = "Shows what a new model keeps, adds, reroutes and removes.",
        mixinStandardHelpOptions = true)
@SuppressWarnings("NullAway.Init") // picocli sets the fields
final class DiffCommand implements Callable<Integer> {
    @Spec
    private CommandSpec spec;

    @Mixin
    private PairParameters models;

    @Option(
            names = "--format",
            defaultValue = "TEXT",
            description = "One of ${COMPLETION-CANDIDATES} (default: ${DEFAULT-VALUE}).")
    private OutputFormat format;

    @Override
    public Integer call() {
        ModelPair pair = models.read(spec);
        String shown = switch (format) {
            case TEXT -> DifferenceText.write(pair);
            case JSON -> DifferenceJson.write(pair);
            case SVG ->
                SvgWriter.write(
                        "From " + pair.original().name() + " to "
                                + pair.evolved().name(),
                        List.of(DifferenceDiagram.of(pair)));
        };
        return Output.print(spec, shown);
    }
}
