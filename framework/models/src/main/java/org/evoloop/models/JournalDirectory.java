package org.evoloop.models;

import java.nio.file.Path;
import org.evoloop.journal.JournalException;
import org.evoloop.journal.JournalFiles;
import picocli.CommandLine.ExitCode;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Parameters;

/** The journal that a command looks into. */
@SuppressWarnings("NullAway.Init") // picocli sets the fields
final class JournalDirectory {
    @Parameters(paramLabel = "DIR", description = "The directory that the converter was given with --journal.")
    private Path directory;

    /** What is done with a journal's records. */
    @FunctionalInterface
    interface Work {
        /** Done before its result is shown; the exit status. */
        int with(JournalFiles files) throws Exception;
    }

    Path path() {
        return directory;
    }

    /** Does some work; a damaged journal is told and is exit status 1. */
    int examine(CommandSpec spec, Work work) throws Exception {
        try {
            return work.with(new JournalFiles(directory));
        } catch (JournalException wrong) {
            if (!wrong.isDamage()) {
                throw wrong;
            }
            spec.commandLine().getOut().flush();
            spec.commandLine().getErr().println("error: " + wrong.getMessage());
            return ExitCode.SOFTWARE;
        }
    }
}
