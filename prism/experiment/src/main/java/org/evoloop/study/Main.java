package org.evoloop.study;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.util.concurrent.Callable;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;

/** Reads points from stdin, one a line, and prints what it measures for each, as soon as it is known. */
@Command(
        name = "study-experiment",
        mixinStandardHelpOptions = true,
        description = {
            "Runs the converter against a simulated device for each point that it reads from stdin:",
            Point.COLUMNS,
            "Prints " + Results.COLUMNS
        })
public final class Main implements Callable<Integer> {
    private final BufferedReader in;
    private final PrintStream out;
    private final PrintStream err;

    @Option(names = "--runs", paramLabel = "N", description = "Short runs for each point (default: ${DEFAULT-VALUE}).")
    private int runs = 2500;

    @Option(
            names = "--batch",
            paramLabel = "SECONDS",
            description = "Length of each of the 100 batches of the long run (default: ${DEFAULT-VALUE}).")
    private int batchSeconds = 2400;

    @Option(names = "--threads", description = "Gives the converter's loop threads of its own.")
    private boolean threads;

    Main(BufferedReader in, PrintStream out, PrintStream err) {
        this.in = in;
        this.out = out;
        this.err = err;
    }

    /** Runs the program and ends the JVM with 0 if it went well, 2 for wrong input. */
    public static void main(String[] arguments) {
        BufferedReader stdin = new BufferedReader(new InputStreamReader(System.in, StandardCharsets.UTF_8));
        System.exit(new CommandLine(new Main(stdin, System.out, System.err)).execute(arguments));
    }

    @Override
    public Integer call() throws IOException {
        out.println(Results.COLUMNS);
        for (@Nullable String line = in.readLine(); line != null; line = in.readLine()) {
            Point point;
            try {
                point = Point.parse(line);
                if (threads && point.disturbances().isAny()) {
                    throw new IllegalArgumentException("'" + line + "': without --threads only");
                }
            } catch (IllegalArgumentException wrong) {
                err.println("error: " + wrong.getMessage());
                return CommandLine.ExitCode.USAGE;
            }
            new Experiment(point, threads).run(runs, batchSeconds).print(point.name(), out);
            out.flush();
        }
        return CommandLine.ExitCode.OK;
    }
}
