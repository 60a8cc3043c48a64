package org.evoloop.config;

import java.util.Locale;
import java.util.Set;
import java.util.function.Predicate;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine;
import picocli.CommandLine.Model.OptionSpec;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.UnmatchedArgumentException;

/**
 * Reports errors of a program: a mistake that the user can fix is one message on stderr and exit status 2.
 *
 * @since 0.1
 */
public final class UsersMistakes {
    private UsersMistakes() {}

    /**
     * Makes a command line and its subcommands report users' mistakes; any other failure is a stack trace and exit
     * status 1.
     *
     * @param mendable whether a command's failure is a mistake that its user can fix
     * @return the same command line
     */
    public static CommandLine reportedBy(CommandLine commandLine, Predicate<Exception> mendable) {
        return commandLine
                .setParameterExceptionHandler((mistake, given) -> {
                    CommandLine command = mistake.getCommandLine();
                    command.getErr()
                            .println("error: " + message(mistake) + " (see "
                                    + command.getCommandSpec().qualifiedName() + " --help)");
                    return CommandLine.ExitCode.USAGE;
                })
                .setExecutionExceptionHandler((failure, command, parsed) -> {
                    if (mendable.test(failure)) {
                        command.getErr().println("error: " + failure.getMessage());
                        return CommandLine.ExitCode.USAGE;
                    }
                    failure.printStackTrace(command.getErr());
                    return CommandLine.ExitCode.SOFTWARE;
                });
    }

    /**
     * Runs a command line whose output is a result.
     *
     * @return the command's exit status; 1 if it succeeded, but the result could not be written in full, as to a full
     *     disk
     */
    public static int execute(CommandLine commandLine, String... arguments) {
        int status = commandLine.execute(arguments);
        // A PrintWriter reports a full disk or a closed pipe only here.
        if (status == CommandLine.ExitCode.OK && commandLine.getOut().checkError()) {
            commandLine
                    .getErr()
                    .println("error: standard output: the result could not be written in full; free some space there,"
                            + " or write it elsewhere");
            return CommandLine.ExitCode.SOFTWARE;
        }
        return status;
    }

    /** Picocli's own message, where it reads well. */
    private static @Nullable String message(ParameterException mistake) {
        if (mistake instanceof UnmatchedArgumentException unmatched && !unmatched.isUnknownOption()) {
            Set<String> commands = mistake.getCommandLine().getSubcommands().keySet();
            return commands.isEmpty()
                    ? "more than it takes: " + String.join(" ", unmatched.getUnmatched())
                    : "there is no command '" + unmatched.getUnmatched().get(0) + "'; there are "
                            + String.join(", ", commands);
        }
        if (mistake.getArgSpec() instanceof OptionSpec option
                && option.typeInfo().isEnum()
                && option.converters().length == 0
                && mistake.getValue() != null) {
            return option.longestName() + ": '" + mistake.getValue() + "' is none of "
                    + String.join(", ", option.typeInfo().getEnumConstantNames())
                            .toLowerCase(Locale.ROOT);
        }
        return mistake.getMessage();
    }
}
