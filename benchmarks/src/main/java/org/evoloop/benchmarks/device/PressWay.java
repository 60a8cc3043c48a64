package org.evoloop.benchmarks.device;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.function.IntFunction;
import org.HdrHistogram.Histogram;
import org.evoloop.benchmarks.report.Figures;
import org.evoloop.benchmarks.report.Row;
import org.evoloop.journal.Forcing;
import org.evoloop.journal.Journal;
import org.evoloop.link.Link;
import org.evoloop.link.SerialLink;
import org.evoloop.link.SerialSettings;
import org.evoloop.loop.LoopConfig;
import org.evoloop.loop.ThreadingModel;
import org.evoloop.time.Clock;

/** How a press leads to a command. */
enum PressWay {
    /** The thread that reads the press writes the command. */
    BARE {
        @Override
        Answerer open(IntFunction<Link> cable, Path folder, Clock clock) throws InterruptedException {
            return new BareAnswerer(cable.apply(SerialSettings.DEFAULT_BAUD), 0, clock);
        }
    },
    /** As many threads in between as a press passes through in the paper. */
    BARE_THREADS {
        @Override
        Answerer open(IntFunction<Link> cable, Path folder, Clock clock) throws InterruptedException {
            return new BareAnswerer(cable.apply(SerialSettings.DEFAULT_BAUD), 3, clock);
        }
    },
    /** The converter; one thread runs all components. */
    CARRIER {
        @Override
        Answerer open(IntFunction<Link> cable, Path folder, Clock clock) throws IOException, InterruptedException {
            return new ConverterAnswerer(cable, config(clock), null);
        }
    },
    /** The converter with one thread per component, as in the paper. */
    THREADS {
        @Override
        Answerer open(IntFunction<Link> cable, Path folder, Clock clock) throws IOException, InterruptedException {
            return new ConverterAnswerer(cable, config(clock).withThreading(ThreadingModel.THREAD_PER_COMPONENT), null);
        }
    },
    /** {@link #CARRIER} with a journal that is forced by batch. */
    JOURNAL_BY_BATCH {
        @Override
        Answerer open(IntFunction<Link> cable, Path folder, Clock clock) throws IOException, InterruptedException {
            return new ConverterAnswerer(cable, config(clock), journal(folder, Forcing.BY_BATCH));
        }
    },
    /** {@link #CARRIER} with a journal that is forced per intent. */
    JOURNAL_PER_INTENT {
        @Override
        Answerer open(IntFunction<Link> cable, Path folder, Clock clock) throws IOException, InterruptedException {
            return new ConverterAnswerer(cable, config(clock), journal(folder, Forcing.PER_INTENT));
        }
    };

    abstract Answerer open(IntFunction<Link> cable, Path folder, Clock clock) throws IOException, InterruptedException;

    /**
     * Connects to the robot.
     *
     * @param port of the robot
     * @param folder for journals
     * @param nanos gets the time of each command
     */
    Answerer open(Path port, Path folder, Clock clock, Histogram nanos) throws IOException, InterruptedException {
        return open(
                baud -> new TimedLink(SerialLink.open(new SerialSettings(port.toString()).withBaud(baud)), nanos),
                folder,
                clock);
    }

    private static LoopConfig config(Clock clock) {
        return LoopConfig.defaults("roomba", clock);
    }

    private static Journal journal(Path folder, Forcing forcing) throws IOException {
        return Journal.in(Files.createTempDirectory(folder, "journal")).withForcing(forcing);
    }

    /** The rows of the table; the goals are ratios within one run, since times depend on the machine's threads. */
    static List<Row> rows(Figures measured) {
        double bare = measured.get("BARE p50");
        double bare99 = measured.get("BARE p99");
        double threads = measured.get("BARE_THREADS p50");
        double threads99 = measured.get("BARE_THREADS p99");
        double carrier = measured.get("CARRIER p50");
        String direct = "a byte sent back by its reader";
        String relayed = "by way of 3 bare threads";
        String without = "without a journal";
        return List.of(
                new Row(
                        "button to command, added by us, median",
                        "us",
                        carrier,
                        Row.Goal.atMostTimes(6, direct, bare),
                        Map.of(relayed, threads, "pages gone after a pause, %", measured.get("slow pages"))),
                new Row(
                        "button to command, added by us, 99th percentile",
                        "us",
                        measured.get("CARRIER p99"),
                        Row.Goal.atMostTimes(6, direct, bare99),
                        Map.of(relayed, threads99)),
                new Row(
                        "button to command, a thread a component, median",
                        "us",
                        measured.get("THREADS p50"),
                        Row.Goal.atMostTimes(1.25, relayed, threads)),
                new Row(
                        "button to command, a thread a component, 99th percentile",
                        "us",
                        measured.get("THREADS p99"),
                        Row.Goal.atMostTimes(1.5, relayed, threads99)),
                new Row(
                        "button to command with a journal by batch, median",
                        "us",
                        measured.get("JOURNAL_BY_BATCH p50"),
                        Row.Goal.atMostTimes(1.1, without, carrier)),
                new Row(
                        "button to command with a journal per intent, median",
                        "us",
                        measured.get("JOURNAL_PER_INTENT p50"),
                        Row.Goal.atMostTimes(50, without, carrier)));
    }
}
