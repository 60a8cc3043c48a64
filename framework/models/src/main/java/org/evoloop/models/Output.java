package org.evoloop.models;

import java.io.PrintWriter;
import picocli.CommandLine.Model.CommandSpec;

/** Where results go: to the standard output, and nothing else goes there. */
final class Output {
    private Output() {}

    /** Says on the standard error what is good to know. */
    static void note(CommandSpec spec, String text) {
        spec.commandLine().getErr().println("note: " + text);
    }

    /** Says on the standard error what has gone wrong beside what is printed. */
    static void error(CommandSpec spec, String text) {
        spec.commandLine().getErr().println("error: " + text);
    }

    /** Prints {@code result} and returns the exit status of a command that has done its work. */
    static int print(CommandSpec spec, String result) {
        PrintWriter out = spec.commandLine().getOut();
        out.print(result);
        out.flush();
        return 0;
    }
}
