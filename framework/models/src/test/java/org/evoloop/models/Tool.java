package org.evoloop.models;

import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Path;
import picocli.CommandLine;

/** A command line run in this process, with its output. */
public record Tool(int status, String out, String err) {
    /** The project's models. */
    public static final String ROBOT = Path.of(System.getProperty("evoloop.root"), "models", "cleaning-robot.xml")
            .toString();

    public static Tool run(String... arguments) {
        StringWriter out = new StringWriter();
        StringWriter err = new StringWriter();
        CommandLine commandLine = Main.commandLine();
        commandLine.setOut(new PrintWriter(out));
        commandLine.setErr(new PrintWriter(err));
        int status = Main.run(commandLine, arguments);
        return new Tool(status, out.toString(), err.toString());
    }
}
