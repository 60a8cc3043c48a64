package org.evoloop.models;

import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Spec;

/** The commands that read a converter's journal. */
@Command(
        name = "journal",
        description = "Reads the journal that a converter keeps with --journal DIR, also while the converter runs.",
        subcommands = {
            JournalShowCommand.class,
            JournalVerifyCommand.class,
            JournalExportCommand.class,
            JournalReplayCommand.class
        },
        mixinStandardHelpOptions = true)
final class JournalCommand implements Runnable {
    @Spec
    @SuppressWarnings("NullAway.Init") // picocli sets it
    private CommandSpec spec;

    @Override
    public void run() {
        throw new ParameterException(
                spec.commandLine(),
                "name a command: " + String.join(", ", spec.subcommands().keySet()));
    }
}
