package org.evoloop.models;

import java.util.List;
import java.util.concurrent.Callable;
import java.util.stream.Collectors;
import org.evoloop.models.diagram.ChartDiagram;
import org.evoloop.models.diagram.SvgWriter;
import org.evoloop.models.format.Dot;
import org.evoloop.models.format.MachineJson;
import org.evoloop.models.format.MachineText;
import org.evoloop.models.format.PlantUml;
import org.evoloop.statechart.Statechart;
import org.evoloop.xmi.ModelWriter;
import picocli.CommandLine.Command;
import picocli.CommandLine.ExitCode;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** Shows machines as drawn. */
@Command(
        name = "show",
        description = "Shows the state machines of a file as they were drawn.",
        mixinStandardHelpOptions = true)
@SuppressWarnings("NullAway.Init") // picocli sets the fields
final class ShowCommand implements Callable<Integer> {
    /** The output formats. */
    enum Format {
        TEXT,
        JSON,
        DOT,
        PLANTUML,
        MERMAID,
        SCXML,
        SVG
    }

    @Spec
    private CommandSpec spec;

    @Parameters(
            paramLabel = "FILE[#NAME]",
            description = "The file, and which of its machines; without #NAME all of them.")
    private String reference;

    @Option(
            names = "--format",
            defaultValue = "TEXT",
            description = "One of ${COMPLETION-CANDIDATES} (default: ${DEFAULT-VALUE}).")
    private Format format;

    @Override
    public Integer call() {
        ModelReader.Drawn drawn = ModelReader.drawn(reference);
        List<Statechart> charts = drawn.charts();
        String shown = switch (format) {
            case TEXT -> MachineText.write(charts);
            case JSON -> MachineJson.write(charts);
            case DOT -> Dot.write(charts);
            case PLANTUML -> PlantUml.write(charts);
            case MERMAID -> mermaid(charts);
            case SCXML -> scxml(charts);
            case SVG ->
                SvgWriter.write(reference, charts.stream().map(ChartDiagram::of).toList());
        };
        drawn.notes().forEach(note -> Output.note(spec, note));
        drawn.problems().forEach(problem -> spec.commandLine().getErr().println("error: " + problem));
        Output.print(spec, charts.isEmpty() ? "" : shown);
        return drawn.problems().isEmpty() ? 0 : ExitCode.USAGE;
    }

    /** A diagram, or a Markdown file with a block for each of several. */
    private static String mermaid(List<Statechart> charts) {
        return charts.size() == 1
                ? ModelWriter.MERMAID.write(charts.get(0))
                : charts.stream()
                        .map(chart -> "```mermaid\n" + ModelWriter.MERMAID.write(chart) + "```\n")
                        .collect(Collectors.joining("\n"));
    }

    private String scxml(List<Statechart> charts) {
        if (charts.size() > 1) {
            throw new IllegalArgumentException("--format: an SCXML document holds one machine; name one of "
                    + charts.stream()
                            .map(chart -> reference + "#" + chart.name())
                            .collect(Collectors.joining(", ")));
        }
        return charts.stream().map(ModelWriter.SCXML::write).collect(Collectors.joining());
    }
}
