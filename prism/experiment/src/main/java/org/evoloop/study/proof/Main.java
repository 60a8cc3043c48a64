package org.evoloop.study.proof;

import static java.util.Objects.requireNonNull;

import java.io.IOException;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.Callable;
import org.evoloop.journal.JournalException;
import org.evoloop.statemachine.ModelException;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;

/** What the proof takes from model files and from the real core, on stdout. */
@Command(
        name = "study-proof",
        mixinStandardHelpOptions = true,
        description = {
            "Prints the decision tables of a pair of models, and of the pair that it may be swapped for, in Promela;",
            "or, with --traces, what the real core does on random inputs, or, with --journal or --record, in recorded runs."
        })
@SuppressWarnings("NullAway.Init") // picocli sets the fields
public final class Main implements Callable<Integer> {
    private final PrintStream out;
    private final PrintStream err;

    @Option(names = "--original", required = true, paramLabel = "FILE#NAME")
    private String original;

    @Option(names = "--new", required = true, paramLabel = "FILE#NAME")
    private String evolved;

    @Option(names = "--next", required = true, paramLabel = "FILE#NAME")
    private String next;

    @Option(names = "--mapping", paramLabel = "FILE")
    private @Nullable Path mapping;

    @Option(names = "--sendable", split = ",", required = true)
    private Set<String> sendable;

    @Option(names = "--pressed", split = ",", description = "What controllers press besides.")
    private Set<String> pressed = Set.of();

    @Option(names = "--spontaneous", split = ",", required = true)
    private Set<String> spontaneous;

    @Option(names = "--timer", paramLabel = "STATE=EVENT")
    private Map<String, String> timers = Map.of();

    @Option(names = "--queue", defaultValue = "2")
    private int queue;

    @Option(names = "--traces", paramLabel = "N", description = "How many traces.")
    private int traces;

    @Option(
            names = "--journal",
            paramLabel = "DIR",
            description = "What the core was told in the run that this journal recorded.")
    private @Nullable Path journal;

    @Option(
            names = "--record",
            paramLabel = "DIR",
            description = "Runs the whole converter with a journal in this empty folder, as often as --traces says,"
                    + " and prints what the core was told.")
    private @Nullable Path recorded;

    @Option(names = "--length", defaultValue = "90", description = "Inputs of a trace, at most.")
    private int length;

    @Option(names = "--seed", defaultValue = "1")
    private long seed;

    Main(PrintStream out, PrintStream err) {
        this.out = out;
        this.err = err;
    }

    /** Runs the program and ends the JVM with 0 if it went well, 2 for wrong input. */
    public static void main(String[] arguments) {
        System.exit(new CommandLine(new Main(System.out, System.err)).execute(arguments));
    }

    @Override
    public Integer call() throws IOException {
        String mapped = mapping == null ? "" : Files.readString(mapping, StandardCharsets.UTF_8);
        EvolvingPair evolution;
        try {
            evolution = EvolvingPair.of(
                    original,
                    evolved,
                    next,
                    mapped,
                    new EvolvingPair.Facts(sendable, pressed, spontaneous, timers, queue));
        } catch (ModelException | IllegalArgumentException wrong) {
            err.println("error: " + wrong.getMessage());
            return CommandLine.ExitCode.USAGE;
        }
        try {
            print(evolution);
        } catch (IllegalArgumentException | JournalException wrong) {
            err.println("error: " + (journal == null ? "" : journal + ": ") + wrong.getMessage());
            return CommandLine.ExitCode.USAGE;
        }
        out.flush();
        return CommandLine.ExitCode.OK;
    }

    private void print(EvolvingPair evolution) throws IOException {
        if (journal != null) {
            out.print(RecordedTrace.of(evolution, journal));
        } else if (traces == 0) {
            out.print(Tables.of(evolution));
        }
        for (int index = 0; index < traces; index++) {
            out.print(recorded == null ? Trace.random(evolution, seed + index, length) : run(evolution, seed + index));
        }
    }

    private String run(EvolvingPair evolution, long number) throws IOException {
        Path folder = Files.createDirectories(requireNonNull(recorded).resolve("run" + number));
        return RecordedTrace.of(evolution, RecordedRun.record(evolution, timers, folder, number, length));
    }
}
