package org.evoloop.models;

import java.io.PrintWriter;
import org.evoloop.statemachine.Names;
import picocli.CommandLine.Model.CommandSpec;

/** Prints results to standard output, which carries nothing else. */
final class Output {
    private Output() {}

    /** Prints a note to standard error. */
    static void note(CommandSpec spec, String text) {
        spec.commandLine().getErr().println("note: " + Names.inOneLine(text));
    }

    /** Prints an error to standard error, in addition to the result. */
    static void error(CommandSpec spec, String text) {
        spec.commandLine().getErr().println("error: " + text);
    }

    /** Prints {@code result} and returns the exit status for success. */
    static int print(CommandSpec spec, String result) {
        PrintWriter out = spec.commandLine().getOut();
        out.print(result);
        out.flush();
        return 0;
    }
}
