package org.evoloop.journal;

import static org.assertj.core.api.Assertions.assertThat;

import java.lang.management.ManagementFactory;
import java.lang.management.ThreadMXBean;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Random;
import org.evoloop.engine.Snapshot;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** How long it takes to replay a hundred thousand inputs; docs/journal.md quotes the figures. */
class RecoveryTimeTest {
    private static final int INPUTS = 100_000;
    private static final int TIMES = 15;

    @TempDir
    private Path directory;

    @Test
    @Tag("slow")
    void aHundredThousandInputs() throws Exception {
        Journal large = Journal.in(directory).withSegmentBytes(1 << 24).withForcing(Forcing.NEVER);
        Snapshot expected;
        JournaledCore kept = new JournaledCore(directory, large);
        kept.input(Story.of(Robot.RULES, new Random(1), INPUTS));
        expected = kept.core.snapshot();

        kept.close();
        long bytes = Directory.segments(directory).get(0).toFile().length();
        ThreadMXBean threads = ManagementFactory.getThreadMXBean();
        long[] nanos = new long[TIMES];
        long[] cpuNanos = new long[TIMES];
        for (int time = 0; time < TIMES; time++) {
            long begun = System.nanoTime();
            long cpuBegun = threads.getCurrentThreadCpuTime();
            Snapshot recovered = JournaledCore.recovered(Robot.RULES, directory, kept.clock);
            nanos[time] = System.nanoTime() - begun;
            cpuNanos[time] = threads.getCurrentThreadCpuTime() - cpuBegun;
            assertThat(recovered).isEqualTo(expected);
        }
        long first = nanos[0];
        Arrays.sort(nanos);
        Arrays.sort(cpuNanos);
        System.out.printf(
                "%d inputs, %d bytes each: the first time %d ms, median %d ms, of the processor %d ms%n",
                INPUTS,
                bytes / INPUTS,
                first / 1_000_000,
                nanos[TIMES / 2] / 1_000_000,
                cpuNanos[TIMES / 2] / 1_000_000);
    }
}
