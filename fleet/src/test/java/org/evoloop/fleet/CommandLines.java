package org.evoloop.fleet;

import java.io.PrintWriter;
import picocli.CommandLine;

/** Runs a command line in this process. */
final class CommandLines {
    private CommandLines() {}

    /** Returns its exit status. */
    static int run(PrintWriter out, PrintWriter err, String... arguments) {
        CommandLine line = Main.commandLine();
        line.setOut(out);
        line.setErr(err);
        return line.execute(arguments);
    }
}
