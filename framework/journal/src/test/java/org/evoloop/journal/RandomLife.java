package org.evoloop.journal;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import java.util.Set;
import org.evoloop.converter.EventAnalyze;
import org.evoloop.converter.EventExecute;
import org.evoloop.converter.Evolution;
import org.evoloop.converter.EvolutionException;
import org.evoloop.converter.PushMonitor;
import org.evoloop.converter.Shadow;
import org.evoloop.converter.StateKnowledge;
import org.evoloop.converter.SystemEventConverter;
import org.evoloop.converter.UnknownEffectException;
import org.evoloop.evolution.ModelPair;
import org.evoloop.evolution.Occurrence;
import org.evoloop.evolution.Step;
import org.evoloop.loop.LoopConfig;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.State;
import org.evoloop.statemachine.StateMachine;
import org.evoloop.statemachine.StateMachineBuilder;
import org.evoloop.statemachine.Transition;
import org.evoloop.time.ManualClock;
import org.jspecify.annotations.Nullable;

/**
 * A player with a journal, without threads, to which anything happens: presses that may become too old, its own buttons,
 * reports that cannot be true, timers, functions that raise events, guards that change, sends and effects that fail or
 * stay unknown, stops and starts in the middle of a send, other components, equal models that take over, a shadow of equal
 * models, crashes anywhere.
 */
final class RandomLife implements AutoCloseable {
    private static final List<String> EVENTS = List.of("play", "pause", "stop", "fade", "doze", "nap");
    private static final List<String> STATES = List.of("Stopped", "Playing", "Paused");
    private static final List<String> OWN = List.of("play", "pause", "stop");

    private final Path directory;
    private final Random random;
    private final ManualClock clock = new ManualClock();
    private final LoopConfig config;
    private SystemEventConverter converter;
    private Buttons buttons;
    private Driver driver;
    private int lives;
    private int drivers;
    private boolean sending;
    private @Nullable Path crash;
    private @Nullable Shadow shadow;

    RandomLife(Path directory, Random random) {
        this.directory = directory;
        this.random = random;
        LoopConfig config = LoopConfig.defaults("player", clock)
                .withQueueCapacity(random.nextInt(9))
                .withoutThreads();
        this.config = random.nextBoolean() ? config : config.withPressAge(Duration.ofSeconds(1 + random.nextInt(9)));
        begin();
    }

    static ModelPair models() {
        return new ModelPair(builder("device").build(), evolved());
    }

    private static StateMachineBuilder builder(String name) {
        return StateMachine.named(name)
                .initial("Stopped")
                .transition("Stopped", "play", "Playing")
                .transition("Playing", "pause", "Paused")
                .transition("Paused", "play", "Playing")
                .transition("Playing", "stop", "Stopped")
                .transition("Paused", "stop", "Stopped");
    }

    private static StateMachine evolved() {
        StateMachineBuilder evolved = builder("new")
                .transition("Paused", "doze", "Dozing")
                .transition("Dozing", "nap", "Napping")
                .transition("Dozing", "tm(2s)", "Stopped")
                .transition("Napping", "tm(2s)", "Playing")
                .transition("Napping", "stop", "Stopped")
                .transition("Fading", "faded", "Stopped")
                .transition("Fading", "tm(4s)", "Paused")
                .defers("Fading", new Event("doze"));
        evolved.transition(
                new Transition(
                        new State("Playing"),
                        new Event("fade", List.of("dark")),
                        new State("Fading"),
                        List.of("beep"),
                        false),
                "");
        evolved.transition(
                new Transition(new State("Playing"), new Event("fade"), new State("Paused"), List.of("beep"), false),
                "");
        return evolved.build();
    }

    private static final class Buttons extends PushMonitor {
        @Override
        protected Set<String> spontaneousEvents() {
            return Set.copyOf(OWN);
        }

        private void acted(String event) {
            push(fromPanel(event, true));
        }

        private void found(String state) {
            push(foundIn(state));
        }
    }

    private final class Driver extends EventExecute {
        Driver(String name) {
            super(name);
        }

        @Override
        protected Set<String> sendableEvents() {
            return Set.copyOf(OWN);
        }

        @Override
        protected void send(Step step) throws IOException {
            sending = true;
            try {
                meanwhile();
            } finally {
                sending = false;
            }
        }

        private void meanwhile() throws IOException {
            while (random.nextInt(3) == 0) {
                something();
            }
            if (random.nextInt(8) == 0) {
                throw new IOException("the cable is out");
            } else if (random.nextInt(10) == 0) {
                throw new UnknownEffectException("no answer");
            } else if (random.nextInt(4) == 0) {
                tookEffect();
            }
        }

        @Override
        protected Optional<String> locate() {
            return random.nextInt(3) == 0 ? Optional.empty() : Optional.of(any(STATES));
        }

        private void obeysLate() {
            tookEffect();
        }
    }

    private final class Lock extends EventAnalyze {
        @Override
        protected org.evoloop.converter.@Nullable Analysis analyze(Occurrence occurrence) {
            return switch (random.nextInt(20)) {
                case 0 -> refuse(occurrence, "it is locked");
                case 1 -> null;
                case 2 -> throw new IllegalStateException("it is broken");
                default -> super.analyze(occurrence);
            };
        }
    }

    private final class Knowing extends StateKnowledge {
        Knowing(ModelPair models) {
            super(models);
        }

        @Override
        protected void registerNewFunctions() {
            guard("dark", random::nextBoolean);
            effect("beep", () -> {
                if (random.nextInt(4) == 0) {
                    throw new IllegalStateException("it is hoarse");
                }
            });
            function("Fading", visit -> {
                visit.after(Duration.ofMillis(random.nextInt(3_000)), () -> {
                    try {
                        visit.send(any(OWN));
                    } catch (InterruptedException e) {
                        Thread.currentThread().interrupt();
                    }
                });
                visit.finishAfter(Duration.ofMillis(random.nextInt(6_000)), "faded");
            });
            OWN.forEach(event -> sends("Fading", event));
            function("Dozing", visit -> {});
            function("Napping", visit -> {});
        }
    }

    private <T> T any(List<T> of) {
        return of.get(random.nextInt(of.size()));
    }

    private void begin() {
        converter = new SystemEventConverter(config);
        buttons = new Buttons();
        driver = new Driver("Driver" + drivers++);
        converter.addMonitor(buttons);
        converter.addAnalyze(new Lock());
        converter.addExecute(driver);
        converter.addKnowledge(new Knowing(models()));
        converter.addKnowledgeFactory(Knowing::new);
        converter.journal(Journal.in(journal()).withForcing(Forcing.NEVER));
        converter.build();
        converter.start();
    }

    /** The directory of the present process's journal. */
    Path journal() {
        return directory.resolve("life" + lives);
    }

    /** Lets this many things happen. */
    void live(int things) throws InterruptedException {
        for (int thing = 0; thing < things; thing++) {
            something();
            observe();
            if (random.nextInt(3) > 0) {
                converter.step();
            }
            if (crash != null) {
                revive();
            } else if (random.nextInt(40) == 0) {
                between();
            }
        }
    }

    private void observe() throws InterruptedException {
        converter.observe(buttons);
    }

    /** Something that can happen at any time. */
    private void something() {
        switch (random.nextInt(16)) {
            case 0, 1 -> buttons.acted(any(OWN));
            case 2 -> buttons.found(any(STATES));
            case 3, 4, 5 -> clock.advance(Duration.ofMillis(random.nextInt(2_500)));
            case 6 -> stopAndStart();
            case 7 -> driver.obeysLate();
            case 8 -> crash();
            default -> press();
        }
        if (sending) {
            try {
                observe();
            } catch (InterruptedException e) {
                Thread.currentThread().interrupt();
            }
        }
    }

    private void press() {
        try {
            buttons.press(any(EVENTS));
        } catch (IllegalStateException fullOrStopped) {
            // Lost, as it should be.
        }
    }

    private void stopAndStart() {
        if (random.nextInt(3) == 0) {
            converter.stop();
        } else {
            converter.start();
        }
    }

    /** Another process will continue from here. */
    private void crash() {
        if (crash != null || random.nextInt(4) > 0) {
            return;
        }
        try {
            Path next = directory.resolve("life" + (lives + 1));
            Files.createDirectory(next);
            for (Path file : Directory.segments(journal())) {
                Files.copy(file, next.resolve(file.getFileName()));
            }
            crash = next;
        } catch (IOException e) {
            throw new IllegalStateException(e);
        }
    }

    private void revive() {
        shadowAgrees();
        converter.close();
        crash = null;
        shadow = null;
        lives++;
        begin();
    }

    /** Something that can happen between two events. */
    private void between() {
        switch (random.nextInt(4)) {
            case 0 -> {
                Driver other = new Driver("Driver" + drivers++);
                converter.exchange(driver.name(), other);
                driver = other;
            }
            case 1 -> shadowAgrees();
            case 2 -> {
                try {
                    shadowAgrees();
                    shadow =
                            converter.shadow(Evolution.to(new Knowing(models())).withoutWayBack());
                } catch (EvolutionException notNow) {
                    // Tried another time.
                }
            }
            default -> {
                try {
                    shadowAgrees();
                    converter.evolve(Evolution.to(new Knowing(models())).withoutWayBack());
                    shadow = null;
                } catch (EvolutionException notNow) {
                    // Tried another time.
                }
            }
        }
    }

    /** The models of the shadow are equal to those that run. */
    void shadowAgrees() {
        Shadow present = shadow;
        if (present != null && !present.report().differences().isEmpty()) {
            throw new AssertionError(
                    "shadow: " + present.report() + " " + present.report().differences());
        }
    }

    @Override
    public void close() {
        shadowAgrees();
        converter.close();
    }
}
