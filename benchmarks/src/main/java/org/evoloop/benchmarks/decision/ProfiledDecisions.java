package org.evoloop.benchmarks.decision;

import java.io.IOException;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import org.evoloop.benchmarks.profile.Recorder;

/** Decisions by the event's name, to be recorded by Flight Recorder. */
public final class ProfiledDecisions {
    private static final int ROUNDS_AT_ONCE = 10_000;

    private ProfiledDecisions() {}

    /**
     * Writes a recording.
     *
     * @param arguments the recording's file, and its length in seconds
     * @throws IllegalStateException if any event took no transition
     */
    public static void main(String[] arguments) throws IOException, InterruptedException {
        Walker walker = new EvoloopWalker(Walk.robot());
        List<String> way = Walk.robot().way();
        long[] fired = {walker.actions()};
        Recorder.record(Path.of(arguments[0]), Duration.ofSeconds(Long.parseLong(arguments[1])), () -> {
            for (int round = 0; round < ROUNDS_AT_ONCE; round++) {
                way.forEach(walker::fire);
            }
            fired[0] += (long) ROUNDS_AT_ONCE * way.size();
        });
        if (walker.actions() != fired[0]) {
            throw new IllegalStateException(walker.actions() + " transitions on " + fired[0] + " events");
        }
    }
}
