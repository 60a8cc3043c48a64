package org.evoloop.models;

import java.io.IOException;
import org.evoloop.statemachine.ModelException;
import picocli.CommandLine;

/** Runs the command line; what its user can mend is one message and exit status 2. */
public final class Main {
    private Main() {}

    public static void main(String[] arguments) {
        System.exit(run(commandLine(), arguments));
    }

    static CommandLine commandLine() {
        return new CommandLine(new ModelsCommand()).setCaseInsensitiveEnumValuesAllowed(true);
    }

    /** Runs the command line and returns the exit status: 0 good, 1 a check failed, 2 wrong usage or input. */
    static int run(CommandLine commandLine, String... arguments) {
        return commandLine
                .setParameterExceptionHandler((mistake, given) -> {
                    CommandLine command = mistake.getCommandLine();
                    command.getErr()
                            .println("error: " + mistake.getMessage() + " (see "
                                    + command.getCommandSpec().qualifiedName() + " --help)");
                    return CommandLine.ExitCode.USAGE;
                })
                .setExecutionExceptionHandler((failure, command, parsed) -> {
                    if (isUsersMistake(failure)) {
                        command.getErr().println("error: " + failure.getMessage());
                        return CommandLine.ExitCode.USAGE;
                    }
                    failure.printStackTrace(command.getErr());
                    return CommandLine.ExitCode.SOFTWARE;
                })
                .execute(arguments);
    }

    private static boolean isUsersMistake(Exception failure) {
        return failure instanceof ModelException
                || failure instanceof IllegalArgumentException
                || failure instanceof IOException;
    }
}
