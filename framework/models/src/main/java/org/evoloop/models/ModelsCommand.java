package org.evoloop.models;

import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Spec;

/** The tool; all it does it does in its subcommands. */
@Command(
        name = "models",
        description = "Shows state machines, checks an evolution before it runs, and starts a converter's project.",
        subcommands = {
            ShowCommand.class,
            CheckCommand.class,
            DiffCommand.class,
            PlanCommand.class,
            MigrateCommand.class,
            FlattenCommand.class,
            ScaffoldCommand.class,
            JournalCommand.class
        },
        mixinStandardHelpOptions = true)
final class ModelsCommand implements Runnable {
    @Spec
    @SuppressWarnings("NullAway.Init") // picocli sets it
    private CommandSpec spec;

    @Override
    public void run() {
        throw new ParameterException(
                spec.commandLine(),
                "say what to do: "
                        + String.join(", ", spec.subcommands().keySet().stream().toList()));
    }
}
