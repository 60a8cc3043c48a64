package org.evoloop.benchmarks;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.List;
import java.util.concurrent.Callable;
import org.jspecify.annotations.Nullable;
import org.openjdk.jmh.profile.GCProfiler;
import org.openjdk.jmh.results.format.ResultFormatType;
import org.openjdk.jmh.runner.Runner;
import org.openjdk.jmh.runner.RunnerException;
import org.openjdk.jmh.runner.format.OutputFormatFactory;
import org.openjdk.jmh.runner.options.ChainedOptionsBuilder;
import org.openjdk.jmh.runner.options.OptionsBuilder;
import org.openjdk.jmh.runner.options.TimeValue;
import org.openjdk.jmh.runner.options.VerboseMode;
import picocli.CommandLine;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;

/** Runs the benchmarks, each in a JVM of its own: one table on stdout, JMH's progress on stderr. */
@Command(
        name = "bench",
        description = "Measures how long an event takes through the converter, and what it allocates.",
        mixinStandardHelpOptions = true)
public final class Main implements Callable<Integer> {
    // As ./evoloop starts programs.
    private static final List<String> JVM_OPTIONS = List.of("-XX:+UseSerialGC", "-XX:TieredStopAtLevel=1");

    private static final String FOOT = """
            EventPathBenchmark: from getEvent's return to the call of the execute component, over all kinds of decisions
            of the paper's cleaning robot; the device costs nothing. Bytes: all threads that live as long as the
            converter, for one whole event. The transcript's logger is off; in use it is at INFO.
            DecisionBenchmark: one look-up; hashMapOfStrings is the yardstick.
            JDK %s, %d processors, %s
            """;

    @Option(names = "--quick", description = "Takes less than a minute; the figures are rougher.")
    private boolean quick;

    @Option(names = "--json", paramLabel = "FILE", description = "Writes all results to FILE, in JMH's format.")
    private @Nullable Path json;

    public static void main(String[] arguments) {
        System.exit(commandLine().execute(arguments));
    }

    /** Its exit status: 0 good, 1 a benchmark failed, 2 wrong usage. */
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
                    return failure instanceof IOException ? CommandLine.ExitCode.USAGE : CommandLine.ExitCode.SOFTWARE;
                });
    }

    @Override
    public Integer call() throws IOException, RunnerException {
        ChainedOptionsBuilder options = new OptionsBuilder()
                .include(Main.class.getPackageName())
                .addProfiler(GCProfiler.class)
                .addProfiler(EventPathProfiler.class)
                .jvmArgs(JVM_OPTIONS.toArray(String[]::new))
                .forks(quick ? 1 : 2)
                .warmupIterations(quick ? 2 : 3)
                .warmupTime(TimeValue.seconds(quick ? 1 : 2))
                .measurementIterations(quick ? 3 : 5)
                .measurementTime(TimeValue.seconds(quick ? 1 : 2))
                .timeout(TimeValue.seconds(30))
                .shouldFailOnError(true);
        Path file = json;
        if (file != null) {
            requireWritable(file);
            options.resultFormat(ResultFormatType.JSON).result(file.toString());
        }
        Runner runner =
                new Runner(options.build(), OutputFormatFactory.createFormatInstance(System.err, VerboseMode.NORMAL));
        System.out.print(ResultTable.of(runner.run(), foot()));
        return CommandLine.ExitCode.OK;
    }

    /** Found out now, not when all has been measured. */
    private static void requireWritable(Path file) throws IOException {
        try {
            Files.newOutputStream(file, StandardOpenOption.CREATE, StandardOpenOption.APPEND)
                    .close();
        } catch (IOException cause) {
            throw new IOException("--json: cannot write " + file + "; name a file in a directory that exists", cause);
        }
    }

    private static String foot() {
        return FOOT.formatted(
                Runtime.version(), Runtime.getRuntime().availableProcessors(), String.join(" ", JVM_OPTIONS));
    }
}
