package org.evoloop.models;

import java.nio.file.Path;
import org.evoloop.journal.JournalException;
import org.evoloop.journal.JournalFiles;
import picocli.CommandLine.ExitCode;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Parameters;

/** The parameter that names a journal. */
@SuppressWarnings("NullAway.Init") // picocli sets the fields
final class JournalDirectory {
    @Parameters(paramLabel = "DIR", description = "The directory that the converter was given with --journal.")
    private Path directory;

    /** Work on a journal's records. */
    @FunctionalInterface
    interface Work {
        /** Does the work, before its result is printed. Returns the exit status. */
        int with(JournalFiles files) throws Exception;
    }

    Path path() {
        return directory;
    }

    /** Does the work. A damaged journal is reported with exit status 1. */
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
