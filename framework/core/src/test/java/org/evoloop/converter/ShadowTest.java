package org.evoloop.converter;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.evoloop.Machines.machine;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import java.util.Set;
import org.evoloop.evolution.ModelPair;
import org.evoloop.evolution.Occurrence;
import org.evoloop.evolution.Step;
import org.evoloop.function.NewFunction;
import org.evoloop.function.Visit;
import org.evoloop.loop.LoopConfig;
import org.evoloop.rehearsal.Difference;
import org.evoloop.statemachine.State;
import org.evoloop.statemachine.StateMachine;
import org.evoloop.time.ManualClock;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** A music player with other models as a shadow of those that run. */
class ShadowTest {
    private final List<Visit> fadings = new ArrayList<>();
    private final Player player = new Player(fadings::add);

    @AfterEach
    void close() {
        player.close();
    }

    private Shadow begin(StateKnowledge next) {
        return player.converter.shadow(Evolution.to(next).withoutWayBack());
    }

    private void press(String... events) {
        for (String event : events) {
            player.press(event);
            player.settle();
        }
    }

    private static List<String> events(Shadow shadow) {
        return shadow.report().differences().stream()
                .map(each -> each.occurrence().label())
                .toList();
    }

    private static StateKnowledge dozing() {
        return Player.dozing(NewFunction.none());
    }

    @Test
    void whatIsDecidedOtherwiseIsKeptAndNothingOfItIsSent() {
        press("play");
        Shadow shadow = begin(Player.knowledge(
                List.of("Fading"), NewFunction.none(), "Paused fade -> Fading", "Fading play -> Playing"));
        press("pause", "fade", "play");

        ShadowReport report = shadow.report();
        assertThat(report).hasToString("'next': 3 events, 1 of them decided differently");
        assertThat(events(shadow)).containsExactly("fade");
        Difference only = report.differences().get(0);
        assertThat(only.then()).isEqualTo("stays in (Paused, Paused): not-acceptable");
        assertThat(only.now()).isEqualTo("(Paused, Paused) -> (Paused, Fading): new-function");
        assertThat(report.at()).hasToString("(Playing, Playing)");
        assertThat(player.sent).containsExactly("play", "pause", "play");
        assertThat(player.converter.status().shadow()).isEqualTo(report.toString());
    }

    @Test
    void timersOfOneOfTheTwoAreReported() {
        press("play", "fade");
        Shadow shadow = begin(dozing());
        player.clock.advance(Duration.ofMillis(11_001));
        assertThat(shadow.report().at()).hasToString("(Stopped, Stopped)");

        press("stop", "play", "fade");
        player.clock.advance(Duration.ofMillis(11_001));
        assertThat(events(shadow)).containsExactly("tm(10s)", "stop", "tm(10s)");
        assertThat(shadow.report().differences().get(0).then()).isEqualTo("had no such timer");
        assertThat(shadow.report().at()).hasToString("(Stopped, Stopped)");
    }

    /** However long after that the next event comes. */
    @Test
    void timersOfTheShadowFireWhenTheyAreDue() {
        Shadow shadow = begin(Player.knowledge(
                List.of("Fading", "Muting"),
                NewFunction.none(),
                "Playing fade -> Fading",
                "Fading tm(1s) -> Muting",
                "Muting tm(1s) -> Stopped"));
        press("play", "fade");
        player.clock.advance(Duration.ofMillis(1_500));
        press("pause");
        player.clock.advance(Duration.ofMillis(700));
        press("play");
        assertThat(events(shadow)).containsExactly("tm(1s)", "pause", "tm(1s)", "play");
        assertThat(shadow.report().at()).hasToString("(Playing, Playing)");
    }

    @Test
    void anotherComponentAndAStopAreSoForBoth() {
        Shadow shadow = begin(dozing());
        player.converter.exchange(player.device.name(), new EventExecute("Other") {
            @Override
            protected Set<String> sendableEvents() {
                return Set.of("play", "pause", "stop");
            }

            @Override
            protected void send(Step step) {}
        });
        press("play", "pause");
        player.converter.stop();
        player.converter.start();
        press("play");
        assertThat(shadow.report()).hasToString("'next': 3 events, 0 of them decided differently");
    }

    @Test
    void timersOfBothAreOneEvent() {
        player.converter.evolve(Evolution.to(dozing()));
        press("play");
        Shadow shadow = begin(dozing());
        press("fade");
        player.clock.advance(Duration.ofSeconds(10));
        player.settle();
        player.clock.advance(Duration.ofSeconds(2));
        assertThat(player.states()).hasToString("(Stopped, Stopped)");
        assertThat(shadow.report()).hasToString("'next': 2 events, 0 of them decided differently");
    }

    @Test
    void eventsOfAFunctionAreReceivedWhereBothAreInItsState() throws Exception {
        Shadow shadow = begin(Player.knowledge(
                List.of("Fading"),
                NewFunction.none(),
                "Playing fade -> Fading",
                "Fading faded -> Paused",
                "Fading stop -> Stopped"));
        press("play", "fade");
        fadings.get(0).raise("faded");
        player.settle();
        assertThat(events(shadow)).containsExactly("faded");
        assertThat(shadow.report().differences().get(0).now()).contains("-> (Paused, Paused), sends pause");
    }

    @Test
    void whatFailsFailsInBoth() {
        Shadow shadow = begin(dozing());
        player.before = () -> {
            throw new IllegalStateException("the cable is loose");
        };
        press("play");
        player.before = () -> {};
        press("play", "pause");
        assertThat(shadow.report()).hasToString("'next': 3 events, 0 of them decided differently");
    }

    @Test
    void aStopEndsTheVisitInBoth() {
        player.converter.evolve(Evolution.to(dozing()));
        press("play", "fade");
        Shadow shadow = begin(dozing());
        player.clock.advance(Duration.ofSeconds(9));
        player.converter.stop();
        player.converter.start();
        player.clock.advance(Duration.ofSeconds(9));
        player.settle();
        assertThat(shadow.report().at()).isEqualTo(player.states()).hasToString("(Playing, Fading)");
        player.clock.advance(Duration.ofSeconds(3));
        player.settle();
        assertThat(shadow.report()).hasToString("'next': 1 event, 0 of them decided differently");
    }

    @Test
    void promotingContinuesFromWhereTheDeviceIs() {
        press("play", "pause");
        Shadow shadow = begin(Player.knowledge(
                List.of("Fading"), NewFunction.none(), "Paused fade -> Fading", "Fading play -> Playing"));
        press("fade");
        assertThat(shadow.report().at()).hasToString("(Paused, Fading)");
        assertThat(shadow.promote().after()).hasToString("(Paused, Paused)");
        assertThat(player.converter.shadow()).isEmpty();
        assertThatThrownBy(shadow::report).isInstanceOf(IllegalStateException.class);
        assertThatThrownBy(shadow::promote).isInstanceOf(IllegalStateException.class);
        press("fade");
        assertThat(player.states()).hasToString("(Paused, Fading)");
    }

    @Test
    void itEndsWhenOthersTakeOverOrBegin() {
        StateKnowledge first = dozing();
        Shadow before = begin(first);
        Shadow shadow = begin(dozing());
        assertThatThrownBy(before::report).isInstanceOf(IllegalStateException.class);
        before.close();
        assertThat(player.converter.shadow()).contains(shadow);
        player.converter.evolve(Evolution.to(first));
        assertThat(player.converter.shadow()).isEmpty();
        assertThat(player.converter.status().shadow()).isEmpty();
    }

    @Test
    void modelsWithoutAPlaceForTheStateAreRefused() {
        press("play", "fade");
        StateKnowledge next = Player.knowledge(List.of(), NewFunction.none());
        assertThatThrownBy(() -> begin(next))
                .isInstanceOf(EvolutionException.class)
                .hasMessageContaining("the next new model has no state Fading");
        assertThat(player.converter.shadow()).isEmpty();
        press("stop");
        assertThat(begin(next).report().events()).isZero();
    }

    @Test
    void propertiesOfTheOtherModelsShowWhatTheyWouldHaveBroken() {
        press("play");
        StateKnowledge next = Player.knowledge(
                List.of("Fading"), NewFunction.none(), "Paused fade -> Fading", "Fading play -> Playing");
        Probation.Watches watches = (table, from) -> {
            assertThat(from).hasToString("(Playing, Playing)");
            return entry -> switch (entry.after().toString()) {
                case "(Paused, Fading)" -> "'Never fading' is broken";
                case "(Stopped, Stopped)" -> throw new IllegalStateException("lost count");
                default -> "";
            };
        };
        Shadow shadow = player.converter.shadow(
                Evolution.to(next).withoutWayBack().withProbation(Probation.NONE.watchedBy(watches)));
        press("pause", "fade", "play", "stop");

        assertThat(shadow.report().faults())
                .extracting(ShadowReport.Fault::why)
                .containsExactly(
                        "'Never fading' is broken",
                        "what watches the properties has failed: java.lang.IllegalStateException: lost count");
        assertThat(shadow.report()).asString().endsWith("decided differently; properties broken: 2");
        assertThat(player.sent).containsExactly("play", "pause", "play", "stop");
    }

    /** Equal models decide the same, whatever happens. */
    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3, 4, 5, 6, 7, 8})
    void equalModelsNeverDiffer(long seed) {
        player.converter.evolve(Evolution.to(dozing()).withoutWayBack());
        Random random = new Random(seed);
        List<String> events = List.of("play", "pause", "stop", "fade", "doze");
        Shadow shadow = begin(dozing());
        for (int step = 0; step < 500; step++) {
            String event = events.get(random.nextInt(events.size()));
            player.before = random.nextInt(10) == 0
                    ? () -> {
                        throw new IllegalStateException("the cable is loose");
                    }
                    : () -> {};
            switch (random.nextInt(5)) {
                case 0 -> {
                    player.clock.advance(Duration.ofSeconds(random.nextInt(12)));
                    // A timer that waits for more than a second counts as one that only the shadow has.
                    player.settle();
                }
                case 1 -> player.acts(events.get(random.nextInt(3)));
                case 2 -> player.found();
                default -> player.press(event);
            }
            if (random.nextInt(3) > 0) {
                player.settle();
            }
        }
        player.settle();
        assertThat(shadow.report().differences()).as("seed %d", seed).isEmpty();
        assertThat(shadow.report().at()).isEqualTo(player.states());
        assertThat(shadow.report().events()).isGreaterThan(200);
    }

    @Test
    void whatNoneOfTheRunningModelsHasIsNoDifference() {
        Shadow shadow = begin(dozing());
        player.acts("eject");
        player.state = new State("Broken");
        player.found();
        player.state = new State("Stopped");

        assertThat(player.outcomes()).containsExactly("eject IGNORED", "found Broken FAILED");
        assertThat(shadow.report()).hasToString("'next': 0 events, 0 of them decided differently");
    }

    /** It ends at once, and must not be taken for the event in progress. */
    @Test
    void whatComesWhileAnotherEventIsInProgressHasSentNothing() {
        Shadow shadow = begin(dozing());
        player.before = () -> player.acts("eject");
        press("play");

        assertThat(player.outcomes()).containsExactly("eject IGNORED", "play HANDLED");
        assertThat(shadow.report()).hasToString("'next': 1 event, 0 of them decided differently");
    }

    @Test
    void theShadowLosesNothingThatTheQueueHasRoomFor() {
        Shadow shadow = begin(dozing());
        player.before = () -> {
            player.before = () -> {};
            for (int waiting = 0; waiting < 4; waiting++) {
                player.press("pause");
                player.press("play");
            }
        };
        press("play");

        assertThat(player.converter.status().queue().dropped()).isZero();
        assertThat(shadow.report()).hasToString("'next': 9 events, 0 of them decided differently");
    }

    @Test
    void anEffectThatFailsFailsInBoth() {
        player.converter.evolve(Evolution.to(beeping()).withoutWayBack());
        Shadow shadow = begin(beeping());
        press("play");

        assertThat(player.outcomes()).endsWith("play FAILED");
        assertThat(shadow.report()).hasToString("'next': 1 event, 0 of them decided differently");
    }

    /** A player whose effect on starting fails. */
    private static StateKnowledge beeping() {
        StateMachine next =
                machine("next", "Stopped play -> Playing / beep", "Playing stop -> Stopped", "Playing pause -> Paused");
        return new StateKnowledge(new ModelPair(Player.MODELS.original(), next)) {
            @Override
            protected void registerNewFunctions() {
                effect("beep", () -> {
                    throw new IllegalStateException("it is hoarse");
                });
            }
        };
    }

    @Test
    void whatAComponentRefusesOrFailsOnItRefusesOrFailsOnForAllModels() throws InterruptedException {
        Shadow shadow = begin(dozing());
        List<EventAnalyze> locks = List.of(
                new EventAnalyze("Lock") {
                    @Override
                    protected @Nullable Analysis analyze(Occurrence occurrence) {
                        return refuse(occurrence, "it is locked");
                    }
                },
                new EventAnalyze("Broken") {
                    @Override
                    protected @Nullable Analysis analyze(Occurrence occurrence) {
                        throw new IllegalStateException("it is broken");
                    }
                },
                new EventAnalyze("Silent") {
                    @Override
                    protected @Nullable Analysis analyze(Occurrence occurrence) {
                        return null;
                    }
                });
        String present = "EventAnalyze";
        for (EventAnalyze lock : locks) {
            player.converter.exchange(present, lock);
            present = lock.name();
            press("play");
        }

        assertThat(player.outcomes()).containsExactly("play IGNORED", "play FAILED", "play IGNORED");
        assertThat(shadow.report()).hasToString("'next': 3 events, 0 of them decided differently");
    }

    @Test
    void aReportThatTheDeviceIsWhereItIsTakenToBeDelaysNothing() {
        press("play", "fade");
        Shadow shadow = begin(dozing());
        player.found();
        player.clock.advance(Duration.ofMillis(11_001));
        assertThat(shadow.report().at()).hasToString("(Stopped, Stopped)");
    }

    @Test
    void aDoubtThatTheSameModelsDoNotHaveIsNoDifference() {
        press("play", "fade");
        Shadow shadow = begin(Player.knowledge(
                List.of("Fading"),
                NewFunction.none(),
                "Playing fade -> Fading",
                "Fading faded -> Stopped",
                "Fading stop -> Stopped"));
        player.device.canBeAsked = true;
        player.after = () -> {
            player.after = () -> {};
            // Whether this came first is unknown.
            player.acts("play");
        };
        press("stop");
        assertThat(player.outcomes()).contains("in doubt HANDLED");
        assertThat(shadow.report().differences()).isEmpty();
        assertThat(shadow.report().at()).isEqualTo(player.states());
    }

    @Test
    void aGuardOfTheDeviceHoldsForAFunctionThatAsks() throws InterruptedException {
        StateMachine lamp =
                machine("lamp", "Off press -> On", "On press -> Off", "On dim [dark] -> Low", "Low press -> Off");
        String[] lines = {
            "Off press -> On",
            "On press -> Off",
            "On dim [dark] -> Low",
            "Low press -> Off",
            "On wait -> Wait",
            "Wait press -> Off"
        };
        PushMonitor button = new PushMonitor("Button");
        try (SystemEventConverter converter = new SystemEventConverter(
                LoopConfig.defaults("lamp", new ManualClock()).withoutThreads())) {
            converter.addMonitor(button);
            converter.addExecute(new EventExecute("Bulb") {
                @Override
                protected Set<String> sendableEvents() {
                    return Set.of("press", "dim");
                }

                @Override
                protected void send(Step step) {}
            });
            converter.addKnowledge(new Dimming(new ModelPair(lamp, machine("new", lines))));
            converter.build();
            converter.start();
            Shadow shadow = converter.shadow(Evolution.to(new Dimming(new ModelPair(lamp, machine("next", lines)))));
            button.press("press");
            button.press("wait");
            converter.observe(button);
            converter.observe(button);
            while (converter.step()) {
                // One after the other.
            }
            assertThat(converter.knowledge().configuration()).hasToString("(Low, Wait)");
            assertThat(shadow.report()).hasToString("'next': 3 events, 0 of them decided differently");
        }
    }

    private static final class Dimming extends StateKnowledge {
        Dimming(ModelPair models) {
            super(models);
        }

        @Override
        protected void registerNewFunctions() {
            guard("dark", () -> true);
            function("Wait", visit -> visit.send("dim"));
            sends("Wait", "dim");
        }
    }
}
