package org.evoloop.models;

import java.util.concurrent.Callable;
import org.evoloop.models.flat.AstahWriter;
import org.evoloop.models.flat.TransitionTable;
import org.evoloop.statemachine.StateMachine;
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
        XMI
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
            description = "One of ${COMPLETION-CANDIDATES} (default: ${DEFAULT-VALUE}); xmi is Astah's and reads back.")
    private Format format;

    @Override
    public Integer call() {
        StateMachine machine = ModelReader.flat(reading.reference(reference), spec);
        if (format == Format.XMI) {
            AstahWriter.losses(machine).forEach(loss -> Output.note(spec, loss));
        }
        return Output.print(spec, format == Format.XMI ? AstahWriter.write(machine) : TransitionTable.write(machine));
    }
}
