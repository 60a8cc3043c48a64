package org.evoloop.program;

import java.util.function.Predicate;
import picocli.CommandLine;

/**
 * How a program tells what went wrong: what its user can mend is one message on stderr and exit status 2.
 *
 * @since 0.1
 */
public final class UsersMistakes {
    private UsersMistakes() {}

    /**
     * Has a command line and its subcommands tell their users' mistakes; any other failure is a stack trace and exit status 1.
     *
     * @param mendable whether a failure of a command is one that its user can mend
     * @return the same command line
     */
    public static CommandLine toldBy(CommandLine commandLine, Predicate<Exception> mendable) {
        return commandLine
                .setParameterExceptionHandler((mistake, given) -> {
                    CommandLine command = mistake.getCommandLine();
                    command.getErr()
                            .println("error: " + mistake.getMessage() + " (see "
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
}
