package org.evoloop.fleet;

import java.io.PrintWriter;
import java.nio.charset.StandardCharsets;
import org.evoloop.config.UsersMistakes;
import org.evoloop.fleet.bench.BenchCommand;
import org.evoloop.fleet.stream.FleetException;
import org.evoloop.fleet.wire.Refusal;
import org.evoloop.statemachine.ModelException;
import picocli.CommandLine;

/** Runs the command line; a user's mistake gives one message and exit status 2. */
public final class Main {
    private Main() {}

    /** Runs the program named by the first argument. */
    public static void main(String[] arguments) {
        CommandLine line = commandLine();
        line.setOut(new PrintWriter(System.out, true, StandardCharsets.UTF_8));
        line.setErr(new PrintWriter(System.err, true, StandardCharsets.UTF_8));
        System.exit(UsersMistakes.execute(line, arguments));
    }

    static CommandLine commandLine() {
        CommandLine line = new CommandLine(new Programs());
        line.getCommandSpec().name("evoloop");
        return UsersMistakes.reportedBy(line, Main::isUsersMistake);
    }

    private static boolean isUsersMistake(Exception failure) {
        return failure instanceof FleetException
                || failure instanceof Refusal
                || failure instanceof ModelException
                || failure instanceof IllegalArgumentException;
    }

    @CommandLine.Command(subcommands = {FleetCommand.class, GatewayCommand.class, BenchCommand.class})
    private static final class Programs {}
}
