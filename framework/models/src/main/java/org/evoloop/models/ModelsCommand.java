package org.evoloop.models;

import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Spec;

/** The command {@code models}; the work is done by its subcommands. */
@Command(
        name = "models",
        description =
                "Shows state machines, checks a pair of models before it runs, and creates a converter's project.",
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
                "name a command: "
                        + String.join(", ", spec.subcommands().keySet().stream().toList()));
    }
}
