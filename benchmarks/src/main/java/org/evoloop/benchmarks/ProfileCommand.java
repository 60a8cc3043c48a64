package org.evoloop.benchmarks;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.concurrent.Callable;
import org.evoloop.benchmarks.decision.ProfiledDecisions;
import org.evoloop.benchmarks.drawing.FlameGraph;
import org.evoloop.benchmarks.profile.Profile;
import org.evoloop.benchmarks.profile.ProfileText;
import org.evoloop.benchmarks.report.Fork;
import org.evoloop.benchmarks.running.ProfiledRobot;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/** Profiles each kind of work in a separate JVM. */
@Command(
        name = "profile",
        description = "Shows which methods take the time and what is allocated, with the JDK's Flight Recorder.",
        mixinStandardHelpOptions = true)
final class ProfileCommand implements Callable<Integer> {
    /** Without these options, inlined methods would not appear. */
    private static final List<String> SEE_EVERYTHING =
            List.of("-XX:+UnlockDiagnosticVMOptions", "-XX:+DebugNonSafepoints");

    @Parameters(
            paramLabel = "WORK",
            description =
                    "decision: by the event's name; conversion: a whole one, without threads; threads: with threads"
                            + " (default: all).")
    private List<String> wanted = new ArrayList<>();

    @Option(
            names = "--seconds",
            paramLabel = "N",
            description = "How long to warm up, and then to record (default: ${DEFAULT-VALUE}).")
    private int seconds = 10;

    @Option(names = "--flame-graphs", paramLabel = "FOLDER", description = "Draws flame-WORK.svg there as well.")
    private @Nullable Path folder;

    /** The kinds of work that can be profiled. */
    private enum Work {
        DECISION("A decision by the event's name", ProfiledDecisions.class),
        CONVERSION("A whole conversion without threads", ProfiledRobot.class),
        THREADS("A whole conversion with threads", ProfiledRobot.class);

        private final String title;
        private final Class<?> main;

        Work(String title, Class<?> main) {
            this.title = title;
            this.main = main;
        }

        static Work named(String name) {
            return Arrays.stream(values())
                    .filter(work -> work.toString().equals(name))
                    .findFirst()
                    .orElseThrow(() -> new IllegalArgumentException(
                            "there is no work " + name + " to look at; there are " + List.of(values())));
        }

        /** In lower case, as on the command line. */
        @Override
        public String toString() {
            return name().toLowerCase(Locale.ROOT);
        }

        Profile profile(int seconds) throws IOException, InterruptedException {
            Path recording = Files.createTempFile("evoloop", ".jfr");
            try {
                Fork.of(main, SEE_EVERYTHING, recording.toString(), Integer.toString(seconds), toString())
                        .figures();
                return Profile.read(recording);
            } finally {
                Files.delete(recording);
            }
        }
    }

    @Override
    public Integer call() throws IOException, InterruptedException {
        if (seconds < 1) {
            throw new IllegalArgumentException("--seconds: " + seconds + " is not 1 or more");
        }
        Path drawn = folder;
        if (drawn != null && !Files.isDirectory(drawn)) {
            throw new IllegalArgumentException("--flame-graphs: there is no folder " + drawn + "; make it");
        }
        List<Work> works = wanted.isEmpty()
                ? List.of(Work.values())
                : wanted.stream().map(Work::named).toList();
        for (Work work : works) {
            System.err.println("evoloop: recording " + work);
            Profile profile = work.profile(seconds);
            System.out.print(work.title + ": " + ProfileText.of(profile));
            if (drawn != null) {
                Files.writeString(drawn.resolve("flame-" + work + ".svg"), FlameGraph.svg(work.title, profile));
            }
        }
        return CommandLine.ExitCode.OK;
    }
}
