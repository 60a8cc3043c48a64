package org.evoloop.journal;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.function.LongSupplier;
import java.util.function.Supplier;
import org.evoloop.converter.ConverterJournal.Past;
import org.evoloop.engine.Core;
import org.evoloop.engine.Input;
import org.evoloop.engine.Inputs;
import org.evoloop.engine.Output;
import org.evoloop.engine.Rules;
import org.evoloop.engine.Snapshot;
import org.evoloop.time.ManualClock;

/** A core with a journal in a directory, with access to the journal's files. */
final class JournaledCore implements AutoCloseable {
    final Path directory;
    final ManualClock clock = new ManualClock();
    final Journal journal;
    final List<Exception> failures = new ArrayList<>();
    final Core core;
    private final Inputs inputs;

    JournaledCore(Path directory, Journal journal) {
        this.directory = directory;
        this.journal = journal;
        Snapshot before = journal.open(Robot.RULES, clock, new Forgetting());
        core = before == null ? new Core(Robot.RULES, output -> {}) : new Core(Robot.RULES, before, output -> {});
        inputs = journal.keep(core, failures::add, () -> {});
    }

    static JournaledCore in(Path directory) {
        return new JournaledCore(directory, Journal.in(directory).withForcing(Forcing.NEVER));
    }

    /** Ignores the replayed past. */
    static final class Forgetting implements Past {
        @Override
        public void at(Supplier<Instant> time, LongSupplier nanos) {}

        @Override
        public void say(Output output) {}
    }

    JournaledCore input(List<Input> all) {
        all.forEach(this::input);
        return this;
    }

    void input(Input input) {
        inputs.apply(input);
        clock.advance(Duration.ofNanos(Math.max(0, core.nowNanos() - clock.nanoTime())));
    }

    Path segment() throws IOException {
        List<Path> segments = Directory.segments(directory);
        return segments.get(segments.size() - 1);
    }

    /** What another process would recover from a copy of the files as they are now. */
    Snapshot recovered(Path copy) throws IOException {
        copyTo(copy);
        return recovered(Robot.RULES, copy, clock);
    }

    void copyTo(Path copy) throws IOException {
        Files.createDirectories(copy);
        for (Path file : Directory.segments(directory)) {
            Files.copy(file, copy.resolve(file.getFileName()));
        }
    }

    static Snapshot recovered(Rules rules, Path directory, ManualClock clock) {
        Journal another = Journal.in(directory).withForcing(Forcing.NEVER);
        try {
            return another.open(rules, clock, new Forgetting());
        } finally {
            another.close();
        }
    }

    @Override
    public void close() {
        journal.close();
    }
}
