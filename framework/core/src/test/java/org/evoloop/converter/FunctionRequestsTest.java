package org.evoloop.converter;

import static org.assertj.core.api.Assertions.assertThat;
import static org.evoloop.converter.Robot.at;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.atomic.AtomicInteger;
import org.evoloop.evolution.Configuration;
import org.evoloop.evolution.Occurrence;
import org.evoloop.evolution.Outcome;
import org.evoloop.evolution.Source;
import org.evoloop.evolution.Values;
import org.evoloop.function.NewFunction;
import org.evoloop.function.Reading;
import org.evoloop.loop.Failure;
import org.evoloop.statemachine.Event;
import org.junit.jupiter.api.Test;

/**
 * Requests by functions to the device, what functions report, the values of events, and the notifications of it all.
 */
class FunctionRequestsTest {

    @Test
    void aFunctionHasTheDeviceDoAnEventInOrderWithAllOthers() {
        try (Player player = new Player(
                visit -> {
                    visit.send("pause");
                    visit.finish("faded");
                },
                "pause")) {
            player.press("play");
            player.press("fade");
            player.settle();
            assertThat(player.sent).containsExactly("play", "pause", "stop");
            assertThat(player.states()).isEqualTo(at("Stopped", "Stopped"));
            assertThat(player.outcomes())
                    .containsExactly("play HANDLED", "fade HANDLED", "pause HANDLED", "faded HANDLED");
        }
    }

    @Test
    void theNewModelStaysWhereItIs() {
        try (Player player = new Player(visit -> visit.send("pause"), "pause")) {
            player.press("play");
            player.press("fade");
            player.settle();
            assertThat(player.states()).isEqualTo(at("Paused", "Fading"));
            assertThat(player.converter.status().function().state()).isEqualTo("Fading");
        }
    }

    @Test
    void whatTheDeviceCannotDoWhereItIsFailsWithItsReason() {
        try (Player player = new Player(visit -> visit.send("play"), "play")) {
            player.press("play");
            player.press("fade");
            player.settle();
            assertThat(player.last().outcome()).isEqualTo(Outcome.FAILED);
            assertThat(player.last().detail())
                    .isEqualTo(
                            "the function of Fading asks for play, but the device has no transition for it in Playing");
            assertThat(player.states()).isEqualTo(at("Playing", "Fading"));
        }
    }

    @Test
    void aFunctionWhoseEndFailsAgainAndAgainTakesItsTime() {
        AtomicInteger runs = new AtomicInteger();
        try (Player player = new Player(visit -> {
            runs.incrementAndGet();
            visit.finish("faded");
        })) {
            player.press("play");
            player.settle();
            player.before = () -> {
                throw new IllegalStateException("the cable is out");
            };
            player.press("fade");
            player.settle();
            assertThat(runs).as("once, and once more").hasValue(2);
            for (int second = 0; second < 60; second++) {
                player.clock.advance(Duration.ofSeconds(1));
                player.settle();
            }
            assertThat(runs).hasValueBetween(15, 30);

            player.before = () -> {};
            player.clock.advance(Duration.ofSeconds(4));
            player.settle();

            assertThat(player.states()).isEqualTo(at("Stopped", "Stopped"));
        }
    }

    @Test
    void aFunctionSaysHowFarItIs() {
        Reading volume = Reading.of("volume", 0.5, "");
        try (Player player = new Player(visit -> visit.progress("half as loud", List.of(volume)))) {
            player.press("play");
            player.press("fade");
            player.settle();
            assertThat(player.converter.status().function())
                    .isEqualTo(new ConverterStatus.RunningFunction("Fading", "", "half as loud", List.of(volume)));

            player.press("stop");
            player.settle();

            assertThat(player.last().detail()).isEqualTo("stop; left Fading at half as loud, volume 0.5");
            assertThat(player.converter.status().function()).isEqualTo(ConverterStatus.RunningFunction.NONE);
        }
    }

    @Test
    void whatAnEventCarriesReachesTheDevice() {
        try (Player player = new Player(NewFunction.none())) {
            player.buttons.press("play", Values.of("volume", 7));
            player.observe();
            player.settle();
            assertThat(player.sent).containsExactly("play volume=7");
        }
    }

    /** Nothing is sent that the models do not say, so what was checked of them holds. */
    @Test
    void whatIsNotDeclaredIsRefusedWithWhereToDeclareIt() {
        try (Player player = new Player(visit -> visit.send("stop"), "play", "pause")) {
            player.press("play");
            player.press("fade");
            player.settle();
            assertThat(player.sent).containsExactly("play");
            assertThat(player.last().outcome()).isEqualTo(Outcome.FAILED);
            assertThat(player.last().detail())
                    .isEqualTo(
                            "the function of Fading asks for stop, which Fading does not declare; draw \"sends stop\""
                                    + " in Fading (SCXML: ev:sends=\"stop\"), or call sends(\"Fading\", \"stop\") in"
                                    + " registerNewFunctions");
        }
    }

    @Test
    void aDeviceThatIsNotReadyKnowsTheValuesOfTheEventToCome() {
        try (Player player = new Player(NewFunction.none())) {
            List<Values> seen = new ArrayList<>();
            player.device.awaitReady = () -> seen.add(player.device.values());
            player.buttons.press("play", Values.of("volume", 7));
            player.observe();
            player.press("stop");
            player.settle();
            assertThat(seen).containsExactly(Values.of("volume", 7), Values.NONE);
        }
    }

    @Test
    void whatAnEventCarriesReachesTheFunctionAndFromThereTheDevice() {
        try (Player player = new Player(
                visit -> {
                    visit.send("pause", visit.values());
                    visit.finish("faded", Values.of("seconds", 3));
                },
                "pause")) {
            player.press("play");
            player.buttons.press("fade", Values.of("volume", 7));
            player.observe();
            player.settle();
            assertThat(player.sent).containsExactly("play", "pause volume=7", "stop seconds=3");
            assertThat(player.converter.history())
                    .extracting(entry -> entry.occurrence().toString())
                    .contains("pause (asked by a function, volume=7)", "faded (function, seconds=3)");
        }
    }

    @Test
    void aFunctionThatStartsAgainHasTheValuesOfTheEventThatLedToItsState() {
        List<Values> seen = new ArrayList<>();
        try (Player player = new Player(visit -> seen.add(visit.values()))) {
            player.press("play");
            player.buttons.press("fade", Values.of("volume", 7));
            player.observe();
            player.settle();
            player.before = () -> {
                throw new IllegalStateException("the cable is out");
            };
            player.buttons.press("stop", Values.of("volume", 1));
            player.observe();
            player.settle();
            player.before = () -> {};
            player.converter.stop();
            player.converter.start();
            assertThat(seen).hasSize(3).containsOnly(Values.of("volume", 7));

            player.press("stop");
            player.press("play");
            player.press("fade");
            player.settle();
            assertThat(seen).hasSize(4).last().isEqualTo(Values.NONE);
        }
    }

    @Test
    void listenersHearInOrderWhatHappens() {
        List<String> heard = new ArrayList<>();
        try (Player player = new Player(NewFunction.none())) {
            player.converter.addListener(new ConverterListener() {
                @Override
                public void moved(Configuration before, Configuration after) {
                    heard.add(before + " to " + after);
                }

                @Override
                public void ended(HistoryEntry entry) {
                    heard.add(entry.occurrence().label() + " " + entry.outcome());
                }
            });
            player.acts("play");
            player.settle();
            player.press("faded");
            player.settle();
        }
        assertThat(heard)
                .containsExactly(
                        "(Stopped, Stopped) to (Playing, Stopped)",
                        "(Playing, Stopped) to (Playing, Playing)",
                        "play HANDLED",
                        "faded IGNORED");
    }

    @Test
    void listenersHearOfAFunctionAndATaskThatFail() {
        List<String> heard = new ArrayList<>();
        try (Player player = new Player(visit -> {
            visit.after(Duration.ofSeconds(1), () -> {
                throw new IllegalStateException("no sound");
            });
            throw new IllegalStateException("no volume");
        })) {
            player.converter.addListener(new ConverterListener() {
                @Override
                public void failed(Failure<Occurrence> failure) {
                    heard.add(failure.toString());
                    throw new IllegalStateException("and the listener fails, too");
                }
            });
            player.press("play");
            player.press("fade");
            player.settle();
            player.clock.advance(Duration.ofSeconds(1));
            player.settle();
        }
        assertThat(heard).containsExactly("Fading.function: no volume", "Fading.function: no sound");
    }

    @Test
    void aFunctionThatStartsAgainAfterItsEndWasOvertakenAgainAndAgainHasItsOwnValues() {
        List<Values> seen = new ArrayList<>();
        try (Player player = new Player(visit -> seen.add(visit.values()))) {
            player.press("play");
            player.buttons.press("fade", Values.of("volume", 7));
            player.observe();
            player.settle();
            player.device.awaitReady = () -> player.acts(player.state.name().equals("Playing") ? "pause" : "play");
            player.buttons.press("stop", Values.of("volume", 1));
            player.observe();
            player.settle();
            assertThat(player.outcomes()).contains("stop FAILED");
            assertThat(seen).containsExactly(Values.of("volume", 7), Values.of("volume", 7));
        }
    }

    @Test
    void anEventThatEndsMeanwhileDoesNotTakeWhatTheFunctionSaid() {
        try (Player player = new Player(visit -> visit.progress("half as loud"))) {
            player.press("play");
            player.press("fade");
            player.settle();
            player.before = () -> player.converter.offer(new Occurrence.Heard(
                    new Event("typo"), Values.NONE, Source.CONTROLLER, Occurrence.ANY_VISIT, player.clock.nanoTime()));
            player.press("stop");
            player.settle();
            assertThat(player.outcomes()).endsWith("typo IGNORED", "stop HANDLED");
            assertThat(player.last().detail()).isEqualTo("stop; left Fading at half as loud");
        }
    }

    @Test
    void aStateThatIsLeftAndEnteredAgainShowsHowFarItsFunctionWas() {
        try (Player player = new Player(visit -> visit.progress("half as loud"))) {
            player.converter.evolve(Evolution.to(Player.knowledge(
                    List.of("Fading"),
                    visit -> visit.progress("half as loud"),
                    "Playing fade -> Fading",
                    "Fading fade -> Fading",
                    "Fading count => Fading",
                    "Fading faded -> Stopped",
                    "Fading stop -> Stopped")));
            player.press("play");
            player.press("fade");
            player.press("fade");
            player.settle();
            assertThat(player.last().detail()).isEqualTo("new function of Fading; left Fading at half as loud");

            player.press("count");
            player.settle();
            assertThat(player.last().outcome()).isEqualTo(Outcome.HANDLED);
            assertThat(player.last().detail()).as("an internal transition").isEmpty();
        }
    }
}
