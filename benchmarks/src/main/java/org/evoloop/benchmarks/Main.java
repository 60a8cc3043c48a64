package org.evoloop.benchmarks;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.Callable;
import org.evoloop.benchmarks.decision.DecisionSuite;
import org.evoloop.benchmarks.device.DeviceSuite;
import org.evoloop.benchmarks.file.FileSuite;
import org.evoloop.benchmarks.loading.LoadingSuite;
import org.evoloop.benchmarks.report.Origin;
import org.evoloop.benchmarks.report.Results;
import org.evoloop.benchmarks.report.Row;
import org.evoloop.benchmarks.report.Suite;
import org.evoloop.benchmarks.report.Table;
import org.evoloop.benchmarks.ring.RingSuite;
import org.evoloop.benchmarks.running.RunningSuite;
import org.evoloop.benchmarks.studio.StudioSuite;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;

/** Runs the measurements, each in a separate JVM. Prints one table to stdout, and progress to stderr. */
@Command(
        name = "bench",
        description = "Compares Evoloop with other libraries on this machine, in one run.",
        mixinStandardHelpOptions = true,
        subcommands = {PlotCommand.class, ProfileCommand.class, SoakCommand.class})
public final class Main implements Callable<Integer> {
    private static final List<Suite> SUITES = List.of(
            new DecisionSuite(),
            new RingSuite(),
            new RunningSuite(),
            new LoadingSuite(),
            new DeviceSuite(),
            new FileSuite(),
            new StudioSuite());

    @Option(names = "--quick", description = "Takes less than ten minutes; the figures are rougher.")
    private boolean quick;

    @Option(
            names = "--only",
            paramLabel = "SUITE",
            split = ",",
            description = "Only these: decision, ring, running, loading, device, file, studio (default: all).")
    private List<String> only = new ArrayList<>();

    @Option(names = "--json", paramLabel = "FILE", description = "Writes the rows to FILE as well.")
    private @Nullable Path json;

    public static void main(String[] arguments) {
        System.exit(commandLine().execute(arguments));
    }

    /** Exit status: 0 everything was measured, 1 a measurement failed, 2 wrong usage. */
    static CommandLine commandLine() {
        return new CommandLine(new Main())
                .setParameterExceptionHandler((mistake, given) -> {
                    mistake.getCommandLine()
                            .getErr()
                            .println("error: " + mistake.getMessage() + " (see ./evoloop bench --help)");
                    return CommandLine.ExitCode.USAGE;
                })
                .setExecutionExceptionHandler((failure, command, parsed) -> {
                    command.getErr().println("error: " + failure.getMessage());
                    return failure instanceof IllegalArgumentException
                            ? CommandLine.ExitCode.USAGE
                            : CommandLine.ExitCode.SOFTWARE;
                });
    }

    @Override
    public Integer call() throws Exception {
        List<Suite> wanted = wanted();
        Path file = json;
        if (file != null) {
            requireWritable("--json", file);
        }
        List<Row> rows = new ArrayList<>();
        for (Suite suite : wanted) {
            System.err.println("evoloop: measuring " + suite.name());
            rows.addAll(suite.measure(quick));
        }
        System.out.print(Table.text(rows));
        Results results = new Results(Origin.here(), rows);
        System.out.println(results.origin().machine());
        if (file != null) {
            Files.writeString(file, results.json());
        }
        return CommandLine.ExitCode.OK;
    }

    private List<Suite> wanted() {
        List<String> names = SUITES.stream().map(Suite::name).toList();
        for (String name : only) {
            if (!names.contains(name)) {
                throw new IllegalArgumentException(
                        "--only: there is no suite " + name + "; there are " + String.join(", ", names));
            }
        }
        return SUITES.stream()
                .filter(suite -> only.isEmpty() || only.contains(suite.name()))
                .toList();
    }

    /** Fails early, not after all measurements. */
    static void requireWritable(String option, Path file) {
        try {
            Files.newOutputStream(file, StandardOpenOption.CREATE, StandardOpenOption.APPEND)
                    .close();
        } catch (IOException cause) {
            throw new IllegalArgumentException(
                    option + ": cannot write " + file + "; name a file in a directory that exists", cause);
        }
    }
}
