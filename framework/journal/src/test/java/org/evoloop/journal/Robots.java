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
import org.evoloop.function.Visit;
import org.evoloop.loop.LoopConfig;
import org.evoloop.statemachine.State;
import org.evoloop.time.ManualClock;

/** The robot with one converter after another; each continues with a copy of its predecessor's journal. */
final class Robots implements AutoCloseable {
    final List<String> sent = new ArrayList<>();
    final List<String> done = new ArrayList<>();

    /** How the visits of SpotWait began. */
    final List<Visit.Beginning> waits = new ArrayList<>();

    ManualClock clock;
    SystemEventConverter converter;
    Buttons buttons;

    /** What happens in the middle of the next sent or executed step. */
    Runnable meanwhile = () -> {};

    /** The state that the device reports; empty if it cannot report it. */
    Optional<String> answer = Optional.empty();

    /** Whether the next converter can create knowledge for other models. */
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
                function("SpotWait", visit -> waits.add(visit.beginning()));
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

    /** Makes writing to the journal fail. */
    void blockJournal() throws IOException {
        Files.move(journal(), directory.resolve("elsewhere"));
    }

    void unblockJournal() throws IOException {
        Files.move(directory.resolve("elsewhere"), journal());
    }

    /** Evolves to other models; timers and functions are found by name. */
    void evolve(ModelPair models) {
        converter.evolve(Evolution.to(new Knowing(models)));
    }

    void settle() throws InterruptedException {
        converter.observe(buttons);
        while (converter.step()) {
            converter.observe(buttons);
        }
    }

    /** Copies the files as they are now. */
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

    /** Another process continues with the copy, at this time of day. */
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

    /** Where the models were replaced, and by which, according to the journal. */
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
