package org.evoloop.converter;

import static org.evoloop.Machines.machine;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Stream;
import org.evoloop.evolution.Configuration;
import org.evoloop.evolution.ModelPair;
import org.evoloop.evolution.Step;
import org.evoloop.function.NewFunction;
import org.evoloop.loop.LoopConfig;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.State;
import org.evoloop.time.ManualClock;

/**
 * A music player with its own buttons, as a converter without threads. The device follows the original model exactly;
 * the new model fades out.
 */
final class Player implements AutoCloseable {
    static final ModelPair MODELS = new ModelPair(
            machine(
                    "original",
                    "Stopped play -> Playing",
                    "Playing pause -> Paused",
                    "Paused play -> Playing",
                    "Playing stop -> Stopped",
                    "Paused stop -> Stopped"),
            machine(
                    "new",
                    "Stopped play -> Playing",
                    "Playing pause -> Paused",
                    "Paused play -> Playing",
                    "Playing stop -> Stopped",
                    "Paused stop -> Stopped",
                    "Playing fade -> Fading",
                    "Fading faded -> Stopped",
                    "Fading stop -> Stopped"));

    final ManualClock clock = new ManualClock();
    final List<String> sent = new ArrayList<>();
    final Buttons buttons = new Buttons();
    final Device device = new Device();
    final SystemEventConverter converter =
            new SystemEventConverter(LoopConfig.defaults("player", clock).withoutThreads());

    /** Where the device truly is. */
    State state = new State("Stopped");

    /** What happens while a step is being sent, before and after it takes effect. */
    Incident before = () -> {};

    Incident after = () -> {};

    /** Something that happens or goes wrong. */
    interface Incident {
        void run() throws Exception;
    }

    /** @param sends what {@code fading} sends */
    Player(NewFunction fading, String... sends) {
        this(fading, new EventAnalyze(), sends);
    }

    Player(NewFunction fading, EventAnalyze analyze, String... sends) {
        converter.addMonitor(buttons);
        converter.addAnalyze(analyze);
        converter.addExecute(device);
        converter.addKnowledge(new StateKnowledge(MODELS) {
            @Override
            protected void registerNewFunctions() {
                function("Fading", fading);
                for (String event : sends) {
                    sends("Fading", event);
                }
            }
        });
        converter.build();
        converter.start();
    }

    /** The player's events plus {@code more}, where {@code functions} are new. */
    static StateKnowledge knowledge(List<String> functions, NewFunction function, String... more) {
        String[] device = {
            "Stopped play -> Playing",
            "Playing pause -> Paused",
            "Paused play -> Playing",
            "Playing stop -> Stopped",
            "Paused stop -> Stopped"
        };
        String[] lines =
                Stream.concat(Arrays.stream(device), Arrays.stream(more)).toArray(String[]::new);
        ModelPair models = new ModelPair(MODELS.original(), machine("next", lines));
        return new StateKnowledge(models) {
            @Override
            protected void registerNewFunctions() {
                functions.forEach(state -> function(state, function));
            }
        };
    }

    /** The same player, which fades for at most ten seconds and can doze. */
    static StateKnowledge dozing(NewFunction function) {
        return knowledge(
                List.of("Fading", "Dozing"),
                function,
                "Playing fade -> Fading",
                "Fading stop -> Stopped",
                "Fading tm(10s) -> Stopped",
                "Paused doze -> Dozing",
                "Dozing play -> Playing");
    }

    final class Buttons extends PushMonitor {
        @Override
        protected Set<String> spontaneousEvents() {
            return Set.of("play", "pause", "stop");
        }

        private void acted(String event) {
            push(fromPanel(event, true));
        }

        private void found(State where) {
            push(foundIn(where.name()));
        }
    }

    final class Device extends EventExecute {
        boolean reportsInOrder;
        boolean canBeAsked;

        /** What happens while the device is not yet ready. */
        Runnable awaitReady = () -> {};

        @Override
        protected Set<String> sendableEvents() {
            return Set.of("play", "pause", "stop");
        }

        @Override
        protected void awaitReady(Step step) {
            awaitReady.run();
        }

        @Override
        protected void send(Step step) throws Exception {
            before.run();
            take(step.trigger());
            sent.add(step.trigger() + (values().isEmpty() ? "" : " " + values()));
            if (reportsInOrder) {
                tookEffect();
            }
            after.run();
        }

        @Override
        protected Optional<String> locate() {
            return canBeAsked ? Optional.of(state.name()) : Optional.empty();
        }
    }

    private void take(Event event) {
        state = MODELS.original().nextState(state, event).orElse(state);
    }

    /** The device's own button is pressed: the device acts, and the converter is notified. */
    void acts(String event) {
        take(new Event(event));
        buttons.acted(event);
        observe();
    }

    void found() {
        buttons.found(state);
        observe();
    }

    /** A control of the controller is operated; the event waits until {@link #settle}. */
    void press(String event) {
        buttons.press(event);
        observe();
    }

    void observe() {
        try {
            converter.observe(buttons);
        } catch (InterruptedException stop) {
            throw new AssertionError(stop);
        }
    }

    Player settle() {
        while (converter.step()) {
            // One after the other.
        }
        return this;
    }

    Configuration states() {
        return converter.knowledge().configuration();
    }

    String doubt() {
        return converter.status().doubt();
    }

    HistoryEntry last() {
        List<HistoryEntry> entries = converter.history();
        return entries.get(entries.size() - 1);
    }

    /** The events that have ended, with their outcomes. */
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
