package org.evoloop.program;

import java.io.IOException;
import java.io.PrintStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import org.evoloop.console.ConsoleCommand;
import org.evoloop.converter.Drift;
import org.evoloop.converter.SystemEventConverter;
import org.evoloop.statechart.FlatDrawing;
import org.evoloop.statemachine.StateMachine;
import org.evoloop.xmi.ModelWriter;

/** The command that shows which acts of the device its model does not have, and writes the model that has them. */
final class DriftCommand {
    private final SystemEventConverter converter;

    private DriftCommand(SystemEventConverter converter) {
        this.converter = converter;
    }

    static ConsoleCommand of(SystemEventConverter converter) {
        return ConsoleCommand.of(
                "drift [FILE]",
                "shows which of the last acts of the device are not in its model; writes the original model that would "
                        + "explain them to FILE, which ends with .mmd or .scxml",
                new DriftCommand(converter)::run);
    }

    private void run(List<String> arguments, PrintStream out) throws IOException {
        Drift drift = converter.status().drift();
        if (drift.unexplained() == 0) {
            out.println("all of the last " + drift.acts() + " acts of the device are in its model");
        } else {
            drift.edges().forEach(edge -> out.println(String.format(Locale.ROOT, "%4d  %s", edge.count(), edge)));
        }
        if (!arguments.isEmpty()) {
            write(Path.of(arguments.get(0)), drift);
            out.println("written: " + arguments.get(0));
        }
    }

    private void write(Path file, Drift drift) throws IOException {
        ModelWriter writer = file.toString().endsWith(".scxml") ? ModelWriter.SCXML : ModelWriter.MERMAID;
        if (writer == ModelWriter.MERMAID && !file.toString().endsWith(".mmd")) {
            throw new IllegalArgumentException(
                    "'" + file + "' has no ending that names a format; use .mmd for Mermaid, or .scxml");
        }
        StateMachine explained = drift.explained(converter.knowledge().models().original());
        Files.writeString(file, writer.write(FlatDrawing.of(explained)));
    }
}
