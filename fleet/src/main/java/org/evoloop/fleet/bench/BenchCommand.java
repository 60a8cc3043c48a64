package org.evoloop.fleet.bench;

import java.io.PrintWriter;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.concurrent.Callable;
import org.evoloop.fleet.broker.LocalBroker;
import org.evoloop.fleet.demo.Latencies;
import org.evoloop.fleet.program.Lamp;
import org.evoloop.fleet.program.Scratch;
import org.evoloop.fleet.stream.KafkaCluster;
import org.evoloop.fleet.wire.ModelRecord;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Spec;

/** Measures the fleet on this machine, in one run. */
@Command(
        name = "bench",
        description = {
            "Measures the fleet with a broker in the same process: throughput compared with a topology that only passes records"
                    + " on, with few and many devices, and the latency of a command. Takes about ten minutes."
        },
        mixinStandardHelpOptions = true)
public final class BenchCommand implements Callable<Integer> {
    private static final int EVENTS = 600_000;

    /** Enough for the JVM to compile nearly everything; in the first round, compiling takes half of the time. */
    private static final int WARM_UP_ROUNDS = 3;

    @Spec
    @SuppressWarnings("NullAway.Init") // picocli sets it
    private CommandSpec spec;

    @Option(names = "--fleet", description = "Measures the fleet instead of a single converter.")
    private boolean fleet;

    @Option(
            names = "--quick",
            description =
                    "Takes some minutes, with one round instead of three and 100,000 devices; the figures are rougher.")
    private boolean quick;

    @Override
    public Integer call() throws Exception {
        if (!fleet) {
            throw new ParameterException(
                    spec.commandLine(), "say --fleet; a single converter has a benchmark of its own");
        }
        ModelRecord lamp = Lamp.waiting(3_600_000);
        try (Scratch scratch = new Scratch();
                LocalBroker broker = LocalBroker.start(scratch.directory().resolve("broker"))) {
            Throughput throughput = new Throughput(KafkaCluster.at(broker.bootstrap()), scratch.directory(), lamp);
            int many = quick ? 100_000 : 1_000_000;
            say("warming up");
            for (int round = 0; round < WARM_UP_ROUNDS; round++) {
                throughput.of(1_000, EVENTS, true, true);
                throughput.of(1_000, EVENTS, false, true);
            }
            List<Throughput.Measured> bare = new ArrayList<>();
            List<Throughput.Measured> ours = new ArrayList<>();
            for (int round = 0; round < (quick ? 1 : 3); round++) {
                say("round " + (round + 1));
                bare.add(throughput.of(1_000, EVENTS, true, true));
                ours.add(throughput.of(1_000, EVENTS, false, true));
            }
            Throughput.Measured passedFew = Throughput.median(bare);
            Throughput.Measured few = Throughput.median(ours);
            head();
            row("bare pass-through, 1,000 devices", passedFew);
            row("fleet, 1,000 devices", few);
            say(String.format(Locale.ROOT, "%,d devices", many));
            Throughput.Measured passedMany = throughput.of(many, Traffic.CYCLE * many, true, true);
            row(String.format(Locale.ROOT, "bare pass-through, %,d devices", many), passedMany);
            Throughput.Measured all = throughput.of(many, Traffic.CYCLE * many, false, true);
            row(String.format(Locale.ROOT, "fleet, %,d devices", many), all);
            say("devices on disk");
            row("fleet, 100,000 devices on disk", throughput.of(100_000, 300_000, false, false));
            compare("1,000 devices", few, passedFew);
            compare("many devices", all, passedMany);
            print(
                    "CPU time per event, many devices / 1,000: fleet %.2f, bare pass-through %.2f",
                    few.perCpuSecond() / all.perCpuSecond(), passedFew.perCpuSecond() / passedMany.perCpuSecond());
            latencies(new Latency(KafkaCluster.at(broker.bootstrap()), scratch.directory(), Lamp.waiting(2_000)));
        }
        return 0;
    }

    private void compare(String where, Throughput.Measured ours, Throughput.Measured bare) {
        print(
                "fleet / bare pass-through, %s: per CPU second %.0f %%, per second %.0f %%",
                where, 100 * ours.perCpuSecond() / bare.perCpuSecond(), 100 * ours.perSecond() / bare.perSecond());
    }

    private void latencies(Latency latency) throws InterruptedException {
        say("latency");
        for (int commitMillis : new int[] {10, 30, 100, 300}) {
            Latencies measured = latency.of(Duration.ofMillis(commitMillis), quick ? 1_000 : 3_000, 300);
            print(
                    "occurrence to command, commit interval %3d ms: p50 %d ms, p99 %d ms",
                    commitMillis, measured.percentile(50), measured.percentile(99));
        }
    }

    private void head() {
        print("%-36s %10s %14s %14s %10s", "", "events/s", "events/CPU s", "bytes/device", "restore s");
    }

    private void row(String what, Throughput.Measured measured) {
        print(
                "%-36s %,10.0f %,14.0f %,14.0f %10.1f",
                what,
                measured.perSecond(),
                measured.perCpuSecond(),
                measured.bytesPerDevice(),
                measured.restoreSeconds());
    }

    private void print(String format, Object... details) {
        PrintWriter out = spec.commandLine().getOut();
        out.println(String.format(Locale.ROOT, format, details).stripTrailing());
        out.flush();
    }

    private void say(String what) {
        spec.commandLine().getErr().println("bench: " + what);
    }
}
