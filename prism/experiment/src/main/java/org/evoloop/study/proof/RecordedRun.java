package org.evoloop.study.proof;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Random;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.evoloop.converter.EventExecute;
import org.evoloop.converter.Evolution;
import org.evoloop.converter.EvolutionException;
import org.evoloop.converter.PushMonitor;
import org.evoloop.converter.StateKnowledge;
import org.evoloop.converter.SystemEventConverter;
import org.evoloop.converter.UnknownEffectException;
import org.evoloop.evolution.ModelPair;
import org.evoloop.evolution.Step;
import org.evoloop.function.NewFunction;
import org.evoloop.journal.Journal;
import org.evoloop.loop.LoopConfig;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.State;
import org.evoloop.statemachine.StateMachine;
import org.evoloop.statemachine.Transition;
import org.evoloop.time.ManualClock;

/**
 * A run of the whole converter, with its threads and a journal: somebody presses at random, the device acts by itself,
 * steps fail, timers come, it is stopped and started, other models take over, and its process ends in the middle of
 * everything.
 *
 * <p>Threading: for one thread; the converter has its own.
 */
final class RecordedRun {
    private static final Duration TIMER = Duration.ofSeconds(2);

    /** So often the device may act until it is found again: the specification has room for some more. */
    private static final int MOST_UNCONFIRMED = 8;

    private static final int MOST_LOOKS = 1_000_000;

    private final EvolvingPair evolution;
    private final Map<String, String> timers;
    private final Path folder;
    private final Random random;
    private final ManualClock clock = new ManualClock();
    private final List<Event> buttons;
    private final Device device;
    private SystemEventConverter converter;
    private Controller controller;
    private Panel panel;
    private int lives;
    private int unconfirmed;

    /** Whether what the converter does has no effect any more. */
    private volatile boolean ended;

    /** Guarded by itself: the converter and the device's own acts move it. */
    private static final class Device {
        private final StateMachine model;
        private State at;

        Device(StateMachine model) {
            this.model = model;
            this.at = model.initial();
        }

        /** Whether it could. */
        synchronized boolean take(Event event) {
            Optional<Transition> taken = model.transition(at, event);
            taken.ifPresent(way -> at = way.target());
            return taken.isPresent();
        }

        synchronized String at() {
            return at.name();
        }
    }

    private static final class Controller extends PushMonitor {
        /** The event is lost if the queue is full. */
        void operate(String event) {
            push(fromController(event));
        }
    }

    private static final class Panel extends PushMonitor {
        private final Set<String> own;

        Panel(Set<String> own) {
            super("Panel");
            this.own = own;
        }

        @Override
        protected Set<String> spontaneousEvents() {
            return own;
        }

        void acted(Event event) {
            push(fromDevice(event.name()));
        }

        void found(String state) {
            push(foundIn(state));
        }
    }

    private final class Driver extends EventExecute {
        private final Random failures = new Random(random.nextLong());

        @Override
        protected Set<String> sendableEvents() {
            return names(evolution.sendable());
        }

        @Override
        protected void send(Step step) throws Exception {
            if (ended) {
                throw new IOException("the process has ended");
            }
            int mishap = failures.nextInt(12);
            if (mishap == 0) {
                throw new IOException("the device refuses");
            }
            device.take(step.trigger());
            if (mishap == 1) {
                throw new UnknownEffectException("no answer came");
            }
        }

        @Override
        protected Optional<String> locate() {
            return failures.nextBoolean() ? Optional.of(device.at()) : Optional.empty();
        }
    }

    private final class Knowing extends StateKnowledge {
        Knowing(ModelPair models) {
            super(models);
        }

        @Override
        protected void registerNewFunctions() {
            for (State state : models().evolved().states()) {
                if (!models().original().hasState(state)) {
                    function(state.name(), NewFunction.none());
                }
                String timer = timers.get(state.name());
                if (timer != null) {
                    timer(state.name(), timer, TIMER);
                }
            }
        }
    }

    private static Set<String> names(Set<Event> events) {
        return events.stream().map(Event::name).collect(Collectors.toSet());
    }

    @SuppressWarnings("NullAway.Init") // begin() sets the converter and its monitors
    private RecordedRun(EvolvingPair evolution, Map<String, String> timers, Path folder, long seed) {
        this.evolution = evolution;
        this.timers = timers;
        this.folder = folder;
        this.random = new Random(seed);
        this.device = new Device(models(false).original());
        this.buttons = evolution.events().stream()
                .filter(event -> models(false).evolved().triggers().contains(event))
                .filter(event -> !timers.containsValue(event.name()))
                .toList();
        begin();
    }

    /**
     * Records a run.
     *
     * @param timers that the program adds, by state
     * @param folder an empty one, for one journal after the other
     * @param acts how often something is done
     * @return where the journal of the whole run is
     */
    static Path record(EvolvingPair evolution, Map<String, String> timers, Path folder, long seed, int acts) {
        RecordedRun run = new RecordedRun(evolution, timers, folder, seed);
        for (int act = 0; act < acts; act++) {
            run.act();
        }
        run.settle();
        run.converter.close();
        return run.journal();
    }

    private ModelPair models(boolean swapped) {
        return evolution.rules(swapped).table().models();
    }

    private Path journal() {
        return folder.resolve("life" + lives);
    }

    private void begin() {
        ended = false;
        converter = new SystemEventConverter(LoopConfig.defaults("recorded", clock)
                .withQueueCapacity(evolution.rules().queueCapacity())
                .withPressAge(Duration.ofDays(365)));
        controller = new Controller();
        panel = new Panel(names(evolution.own()));
        converter.addMonitor(controller);
        converter.addMonitor(panel);
        converter.addExecute(new Driver());
        converter.addKnowledge(new Knowing(models(false)));
        converter.addKnowledgeFactory(Knowing::new);
        converter.journal(Journal.in(journal()));
        converter.build();
        converter.start();
    }

    private void act() {
        int what = random.nextInt(20);
        if (what < 8) {
            controller.operate(any(buttons).name());
        } else if (what < 12) {
            actByItself();
        } else if (what < 14) {
            clock.advance(TIMER);
        } else if (what == 14) {
            find();
        } else if (what == 15) {
            converter.stop();
            converter.start();
        } else if (what == 16) {
            swap();
        } else if (what == 17) {
            crash();
        } else {
            settle();
        }
    }

    private Event any(List<Event> events) {
        return events.get(random.nextInt(events.size()));
    }

    private void actByItself() {
        Event own = any(List.copyOf(evolution.own()));
        if (device.take(own)) {
            panel.acted(own);
            unconfirmed++;
        }
        if (unconfirmed == MOST_UNCONFIRMED) {
            find();
            settle();
        }
    }

    private void find() {
        panel.found(device.at());
        unconfirmed = 0;
    }

    /** Other models take over, if they can at this moment. */
    private void swap() {
        boolean swapped = converter.knowledge().models().equals(models(true));
        try {
            converter.evolve(Evolution.to(new Knowing(models(!swapped)))
                    .withMapping(swapped ? evolution.mapping().reversed() : evolution.mapping())
                    .withDeadline(Duration.ZERO)
                    .withoutWayBack());
        } catch (EvolutionException notNow) {
            settle();
        }
    }

    /** The next process continues with the files as they are at this moment. */
    private void crash() {
        Path before = journal();
        ended = true;
        lives++;
        try (Stream<Path> files = Files.list(before)) {
            Files.createDirectory(journal());
            for (Path file :
                    files.filter(each -> each.toString().endsWith(".journal")).toList()) {
                copy(file, journal().resolve(file.getFileName()));
            }
        } catch (IOException cause) {
            throw new UncheckedIOException(cause);
        }
        converter.close();
        begin();
    }

    /** Copies a file that may be shortened meanwhile: as it was, or as it is then. */
    private static void copy(Path from, Path to) throws IOException {
        long size;
        do {
            size = Files.size(from);
            Files.copy(from, to, StandardCopyOption.REPLACE_EXISTING);
        } while (Files.size(from) != size || Files.size(to) != size);
    }

    /** Until nothing waits, or for long enough. */
    private void settle() {
        for (int look = 0; look < MOST_LOOKS && converter.status().queue().depth() > 0; look++) {
            Thread.onSpinWait();
        }
    }
}
