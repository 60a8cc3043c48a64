package org.evoloop.models;

import java.util.List;
import java.util.concurrent.Callable;
import org.evoloop.models.flat.AstahWriter;
import org.evoloop.models.flat.FlatLosses;
import org.evoloop.models.flat.TransitionTable;
import org.evoloop.statechart.FlatDrawing;
import org.evoloop.statemachine.StateMachine;
import org.evoloop.xmi.ModelWriter;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** Flattens a drawn machine into an equivalent flat one. */
@Command(
        name = "flatten",
        description = "Gives the flat machine that accepts the same events with the same actions.",
        mixinStandardHelpOptions = true)
@SuppressWarnings("NullAway.Init") // picocli sets the fields
final class FlattenCommand implements Callable<Integer> {
    /** The output formats. */
    enum Format {
        TABLE,
        XMI,
        MERMAID,
        SCXML
    }

    @Spec
    private CommandSpec spec;

    @Mixin
    private ReadingOptions reading;

    @Parameters(paramLabel = "FILE#NAME", description = "The file, and which of its machines.")
    private String reference;

    @Option(
            names = "--format",
            defaultValue = "TABLE",
            description =
                    "One of ${COMPLETION-CANDIDATES} (default: ${DEFAULT-VALUE}); all but the table read back; xmi is Astah's.")
    private Format format;

    @Override
    public Integer call() {
        StateMachine machine = ModelReader.flat(reading.reference(reference), spec);
        List<String> losses = switch (format) {
            case TABLE -> List.of();
            case XMI -> AstahWriter.losses(machine);
            case MERMAID, SCXML -> FlatLosses.of(machine);
        };
        losses.forEach(loss -> Output.note(spec, loss));
        return Output.print(
                spec,
                switch (format) {
                    case TABLE -> TransitionTable.write(machine);
                    case XMI -> AstahWriter.write(machine);
                    case MERMAID -> ModelWriter.MERMAID.write(FlatDrawing.of(machine));
                    case SCXML -> ModelWriter.SCXML.write(FlatDrawing.of(machine));
                });
    }
}
