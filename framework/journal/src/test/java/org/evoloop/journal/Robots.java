package org.evoloop.journal;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.evoloop.converter.EventExecute;
import org.evoloop.converter.Evolution;
import org.evoloop.converter.PushMonitor;
import org.evoloop.converter.StateKnowledge;
import org.evoloop.converter.SystemEventConverter;
import org.evoloop.evolution.ModelPair;
import org.evoloop.evolution.Step;
import org.evoloop.function.NewFunction;
import org.evoloop.loop.LoopConfig;
import org.evoloop.statemachine.State;
import org.evoloop.time.ManualClock;

/** The robot with one converter after the other; each goes on with a copy of the journal of the one before. */
final class Robots implements AutoCloseable {
    final List<String> sent = new ArrayList<>();
    final List<String> done = new ArrayList<>();
    ManualClock clock;
    SystemEventConverter converter;
    Buttons buttons;

    /** What happens in the middle of what is sent or run next. */
    Runnable meanwhile = () -> {};

    /** Where the device says that it is; empty if it cannot tell. */
    Optional<String> answer = Optional.empty();

    /** Whether the next converter can make knowledge of other models. */
    boolean evolving = true;

    private final Path directory;
    private int lives;

    Robots(Path directory) throws IOException {
        this.directory = directory;
        begin(Duration.ZERO);
    }

    static final class Buttons extends PushMonitor {
        void report(String event) {
            push(fromDevice(event));
        }
    }

    private final class Driver extends EventExecute {
        @Override
        protected Set<String> sendableEvents() {
            return Set.of("Clean", "Spot");
        }

        @Override
        protected void send(Step step) {
            sent.add(step.trigger().name());
            meanwhile.run();
        }

        @Override
        protected Optional<String> locate() {
            return answer;
        }
    }

    private final class Knowing extends StateKnowledge {
        Knowing(ModelPair models) {
            super(models);
        }

        @Override
        protected void registerNewFunctions() {
            if (models().evolved().hasState(new State("SpotWait"))) {
                timer("SpotWait", "timeout", Duration.ofSeconds(5));
                function("SpotWait", NewFunction.none());
            }
            function("Move", visit -> done.add("move"));
            effect("beep", () -> {
                done.add("beep");
                meanwhile.run();
            });
        }
    }

    private void begin(Duration time) {
        clock = new ManualClock();
        clock.advance(time);
        converter = new SystemEventConverter(LoopConfig.defaults("robot", clock).withoutThreads());
        buttons = new Buttons();
        converter.addMonitor(buttons);
        converter.addExecute(new Driver());
        converter.addKnowledge(new Knowing(Robot.MODELS));
        if (evolving) {
            converter.addKnowledgeFactory(Knowing::new);
        }
        converter.journal(Journal.in(journal()).withForcing(Forcing.NEVER));
        converter.build();
    }

    private Path journal() {
        return directory.resolve("life" + lives);
    }

    void press(String event) throws InterruptedException {
        buttons.press(event);
        converter.observe(buttons);
    }

    /** Nothing new can be written to the journal. */
    void blockJournal() throws IOException {
        Files.move(journal(), directory.resolve("elsewhere"));
    }

    void unblockJournal() throws IOException {
        Files.move(directory.resolve("elsewhere"), journal());
    }

    /** Other models take over; timers and functions go by name. */
    void evolve(ModelPair models) {
        converter.evolve(Evolution.to(new Knowing(models)));
    }

    void settle() throws InterruptedException {
        converter.observe(buttons);
        while (converter.step()) {
            converter.observe(buttons);
        }
    }

    /** The files as they are at this moment. */
    void copy() {
        try {
            Path next = directory.resolve("life" + (lives + 1));
            Files.createDirectory(next);
            for (Path file : Directory.segments(journal())) {
                Files.copy(file, next.resolve(file.getFileName()));
            }
        } catch (IOException e) {
            throw new IllegalStateException(e);
        }
    }

    /** Another process goes on with the copy, at this time of day. */
    void revive(Duration time) {
        meanwhile = () -> {};
        converter.close();
        lives++;
        begin(time);
    }

    void copyAndRevive() {
        copy();
        revive(Duration.ofNanos(clock.nanoTime()));
    }

    String states() {
        return converter.status().states().toString();
    }

    /** Where other models took over, and which, as the journal tells. */
    List<String> swaps() {
        List<String> swaps = new ArrayList<>();
        new JournalFiles(journal()).read(each -> {
            if (each.kind().equals("evolved")) {
                swaps.add("[" + each.where() + ", " + String.join(", ", each.endings()) + "]");
            }
        });
        return swaps;
    }

    List<String> outcomes() {
        return converter.history().stream()
                .map(entry -> entry.occurrence().label() + " " + entry.outcome())
                .toList();
    }

    @Override
    public void close() {
        converter.close();
    }
}
