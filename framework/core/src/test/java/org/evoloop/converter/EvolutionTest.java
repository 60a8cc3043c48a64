package org.evoloop.converter;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import org.evoloop.evolution.ModelPair;
import org.evoloop.evolution.Occurrence;
import org.evoloop.evolution.Source;
import org.evoloop.evolution.Values;
import org.evoloop.function.NewFunction;
import org.evoloop.function.Visit;
import org.evoloop.migration.Mapping;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.ModelException;
import org.evoloop.statemachine.State;
import org.evoloop.statemachine.StateMachine;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;

/** A music player whose models are replaced while it plays. */
class EvolutionTest {
    private final List<Visit> fadings = new ArrayList<>();
    private final Player player = new Player(fading(fadings));

    private static NewFunction fading(List<Visit> visits) {
        return visit -> {
            visits.add(visit);
            visit.onEnd(() -> visits.remove(visit));
        };
    }

    @AfterEach
    void close() {
        player.close();
    }

    private void playAndFade() {
        player.press("play");
        player.press("fade");
        player.settle();
        assertThat(player.states()).hasToString("(Playing, Fading)");
    }

    @Test
    void aRunningFunctionContinuesAndItsEventsAreReceived() throws Exception {
        playAndFade();
        Visit fading = fadings.get(0);
        Evolution.Result result = player.converter.evolve(Evolution.to(Player.knowledge(
                List.of("Fading"),
                NewFunction.none(),
                "Playing fade -> Fading",
                "Fading faded -> Paused",
                "Fading stop -> Stopped")));

        assertThat(result.after()).hasToString("(Playing, Fading)");
        assertThat(result.carried()).hasToString("[function Fading kept]");
        assertThat(fadings).containsExactly(fading);
        fading.raise("faded");
        player.settle();
        assertThat(player.states()).as("in the next model").hasToString("(Paused, Paused)");
        assertThat(player.sent).containsExactly("play", "pause");
    }

    @Test
    void aVisitSaysThatOtherModelsHaveTakenItOver() {
        playAndFade();
        Visit kept = fadings.get(0);
        assertThat(kept.beginning()).isEqualTo(Visit.Beginning.NEW);
        player.converter.evolve(Evolution.to(Player.dozing(fading(fadings))));
        assertThat(kept.beginning()).isEqualTo(Visit.Beginning.TAKEN_OVER);
        assertThat(kept.isActive()).isTrue();

        player.converter.evolve(Evolution.to(Player.knowledge(
                        List.of("Fading"), fading(fadings), "Paused fade -> Fading", "Fading stop -> Stopped"))
                .withoutWayBack());
        player.settle();
        assertThat(fadings)
                .as("the function is started again where the device has been sent to")
                .doesNotContain(kept)
                .extracting(Visit::beginning)
                .containsExactly(Visit.Beginning.TAKEN_OVER);
        player.press("stop");
        player.press("play");
        player.press("pause");
        player.press("fade");
        player.settle();
        assertThat(fadings.get(0).beginning()).isEqualTo(Visit.Beginning.NEW);
    }

    @Test
    void eventsThatWaitAreDecidedByTheNextModels() {
        player.press("play");
        player.settle();
        player.press("pause");
        player.press("play");
        player.converter.evolve(Evolution.to(Player.dozing(NewFunction.none())));
        player.settle();
        assertThat(player.outcomes()).containsExactly("play HANDLED", "pause HANDLED", "play HANDLED");
        player.press("pause");
        player.press("doze");
        player.settle();
        assertThat(player.states()).hasToString("(Paused, Dozing)");
    }

    @Test
    void whatTheDeviceHasDoneIsKnownAfterwards() {
        player.press("play");
        player.settle();
        player.acts("pause");
        player.converter.evolve(Evolution.to(Player.dozing(NewFunction.none())));
        player.settle();
        assertThat(player.states()).hasToString("(Paused, Paused)");
        assertThat(player.sent).containsExactly("play");
    }

    @Test
    void aTimerKeepsWhatIsLeftOfItUnderAnotherName() {
        StateKnowledge first = Player.dozing(NewFunction.none());
        player.converter.evolve(Evolution.to(first));
        playAndFade();
        player.clock.advance(Duration.ofSeconds(8));
        StateKnowledge next = Player.knowledge(
                List.of("Muting"), NewFunction.none(), "Playing fade -> Muting", "Muting tm(20s) -> Paused");
        Mapping mapping = Mapping.parse(
                "m", "state Fading -> Muting\ntimer tm(10s) of Fading -> tm(20s)\n", first.models(), next.models());
        Evolution.Result result =
                player.converter.evolve(Evolution.to(next).withMapping(mapping).withoutWayBack());
        assertThat(result.carried()).extracting(Object::toString).contains("timer tm(10s) kept as tm(20s)");
        player.clock.advance(Duration.ofMillis(1_999));
        player.settle();
        assertThat(player.states()).hasToString("(Playing, Muting)");
        player.clock.advance(Duration.ofMillis(1));
        player.settle();
        assertThat(player.states()).hasToString("(Paused, Paused)");
    }

    @Test
    void theDeviceIsSentToWhereBothStandTogether() {
        playAndFade();
        Evolution.Result result = player.converter.evolve(Evolution.to(Player.knowledge(
                        List.of("Fading"), fading(fadings), "Paused fade -> Fading", "Fading stop -> Stopped"))
                .withoutWayBack());
        assertThat(result.steps()).hasToString("[Playing --pause--> Paused]");
        assertThat(fadings)
                .as("nothing runs before the device has arrived there")
                .isEmpty();
        player.settle();
        assertThat(player.sent).containsExactly("play", "pause");
        assertThat(player.states()).hasToString("(Paused, Fading)");
        assertThat(fadings).hasSize(1);
        assertThat(player.last().occurrence().label()).isEqualTo("evolved to next");
    }

    @Test
    void noFunctionRunsBeforeTheDeviceHasArrivedThereEvenAfterAStart() {
        playAndFade();
        player.converter.evolve(Evolution.to(Player.knowledge(
                        List.of("Fading"), fading(fadings), "Paused fade -> Fading", "Fading stop -> Stopped"))
                .withoutWayBack());
        player.converter.stop();
        player.converter.start();
        List<Integer> running = new ArrayList<>();
        player.before = () -> running.add(fadings.size());
        player.settle();
        assertThat(running).as("functions while pause was sent").containsExactly(0);
        assertThat(player.states()).hasToString("(Paused, Fading)");
        assertThat(fadings).hasSize(1);
    }

    /** That is nothing that the models have done wrong, so it does not end their probation. */
    @Test
    void theNewModelFollowsWhatSomeoneHasDoneToTheDevice() {
        playAndFade();
        player.acts("pause");
        player.settle();
        assertThat(player.states()).hasToString("(Paused, Fading)");

        Evolution.Result result = player.converter.evolve(Evolution.to(Player.dozing(NewFunction.none()))
                .withMapping(Mapping.byName().withState(new State("Fading"), new State("Playing")))
                .withProbation(Probation.of(Duration.ofMinutes(1))));
        player.settle();

        assertThat(result.after()).hasToString("(Paused, Paused)");
        assertThat(player.states()).hasToString("(Paused, Paused)");
        assertThat(player.sent).containsExactly("play");
        assertThat(player.converter.status().evolution()).contains("on probation");
    }

    @Test
    void theDeviceItselfMayHaveLearntSomething() {
        player.press("play");
        player.settle();
        StateMachine device = StateMachine.named("firmware 2")
                .initial("Stopped")
                .transition("Stopped", "play", "Playing")
                .transition("Playing", "pause", "Paused")
                .transition("Paused", "play", "Playing")
                .transition("Playing", "stop", "Stopped")
                .transition("Paused", "stop", "Stopped")
                .transition("Playing", "ended", "Asleep")
                .transition("Asleep", "play", "Playing")
                .spontaneous("ended")
                .build();
        player.converter.evolve(
                Evolution.to(new StateKnowledge(new ModelPair(device, device))).withoutWayBack());
        long now = player.clock.nanoTime();
        player.converter.offer(new Occurrence.Heard(
                new Event("ended"), Values.NONE, Source.DEVICE, true, Set.of(), Occurrence.ANY_VISIT, now));
        player.settle();
        assertThat(player.states()).hasToString("(Asleep, Asleep)");
        player.press("play");
        player.settle();
        assertThat(player.states()).hasToString("(Playing, Playing)");
    }

    @Test
    void rollingBackLeadsToTheModelsBefore() {
        playAndFade();
        Visit fading = fadings.get(0);
        player.converter.evolve(Evolution.to(Player.dozing(NewFunction.none())));
        assertThat(player.converter.rollBack().model()).isEqualTo("new");
        assertThat(fadings).containsExactly(fading);
        player.press("faded");
        player.settle();
        assertThat(player.states()).hasToString("(Stopped, Stopped)");
        assertThatThrownBy(player.converter::rollBack).hasMessageContaining("nothing to roll back to");
    }

    @Test
    void aFailedEventOnProbationRollsBack() {
        player.converter.evolve(
                Evolution.to(Player.dozing(NewFunction.none())).withProbation(Probation.of(Duration.ofMinutes(1))));
        player.press("play");
        player.settle();
        assertThat(player.converter.knowledge().models().evolved().name()).isEqualTo("next");
        player.before = () -> {
            throw new IllegalStateException("the cable is loose");
        };
        player.press("pause");
        player.settle();
        assertThat(player.converter.knowledge().models()).isSameAs(Player.MODELS);
    }

    @Test
    void aListenerOfAnEvolutionSeesItsProbationInTheStatus() {
        List<String> seen = new ArrayList<>();
        player.converter.addListener(new ConverterListener() {
            @Override
            public void evolved(Evolution.Result result) {
                seen.add(player.converter.status().evolution());
            }
        });
        player.converter.evolve(
                Evolution.to(Player.dozing(NewFunction.none())).withProbation(Probation.of(Duration.ofMinutes(1))));
        assertThat(seen).containsExactly("'next', which took over from 'new', on probation for 60 s");
        player.converter.rollBack();
        assertThat(seen).last().isEqualTo("");
    }

    @Test
    void theStatusNeverShowsATakeoverWithoutItsProbation() {
        List<String> seen = new ArrayList<>();
        Runnable look = () -> seen.add(player.converter.status().evolution());
        player.converter.evolve(Evolution.to(Player.dozing(NewFunction.none()))
                .withProbation(Probation.of(Duration.ofMinutes(1)).watchedBy((table, from) -> {
                    look.run();
                    return entry -> "";
                })));
        look.run();
        assertThat(seen).containsExactly("", "'next', which took over from 'new', on probation for 60 s");
    }

    @Test
    void aProbationEnds() {
        player.converter.evolve(
                Evolution.to(Player.dozing(NewFunction.none())).withProbation(Probation.of(Duration.ofMinutes(1))));
        player.clock.advance(Duration.ofMinutes(1));
        player.before = () -> {
            throw new IllegalStateException("the cable is loose");
        };
        player.press("play");
        player.settle();
        assertThat(player.converter.knowledge().models().evolved().name()).isEqualTo("next");
    }

    @Test
    void whatIsImpossibleIsRefusedAndChangesNothing() {
        playAndFade();
        assertThatThrownBy(() -> player.converter.evolve(Evolution.to(Player.knowledge(List.of(), NewFunction.none()))))
                .isInstanceOf(EvolutionException.class)
                .hasMessageContaining("the next new model has no state Fading; map it: state Fading -> STATE");
        assertThatThrownBy(() -> player.converter.evolve(
                        Evolution.to(Player.knowledge(List.of(), NewFunction.none(), "Playing fade -> Fading"))))
                .isInstanceOf(ModelException.class)
                .hasMessageContaining("new state Fading has no function");
        assertThatThrownBy(() -> player.converter.evolve(Evolution.to(Player.knowledge(
                        List.of("Fading", "Dead"),
                        NewFunction.none(),
                        "Playing fade -> Fading",
                        "Fading stop -> Stopped",
                        "Playing die -> Dead"))))
                .isInstanceOf(ModelException.class)
                .hasMessageContaining("from some states of 'next' no way leads back to 'new'")
                .hasMessageContaining("(Playing, Dead)");
        assertThat(player.converter.knowledge().models()).isSameAs(Player.MODELS);
        assertThat(fadings).hasSize(1);
        player.press("faded");
        player.settle();
        assertThat(player.states()).hasToString("(Stopped, Stopped)");
    }

    @Test
    void codeThatKnowsMoreThanTheModelsIsLeftOut() {
        player.converter.evolve(Evolution.to(Player.knowledge(List.of("Fading"), NewFunction.none())));
        player.press("play");
        player.settle();
        assertThat(player.states()).hasToString("(Playing, Playing)");
    }

    @Test
    void knowledgeThatWasRefusedCanBeUsedAgain() {
        playAndFade();
        StateKnowledge next = Player.knowledge(List.of(), NewFunction.none());
        assertThatThrownBy(() -> player.converter.evolve(Evolution.to(next))).isInstanceOf(EvolutionException.class);
        player.press("stop");
        player.settle();
        player.converter.evolve(Evolution.to(next));
        assertThat(player.converter.knowledge()).isSameAs(next);
        assertThat(next.getCurrentState()).isEqualTo(new State("Stopped"));
    }

    @Test
    void aRecordInDoubtOnProbationRollsBackOnceTheDeviceWasAsked() {
        player.converter.evolve(
                Evolution.to(Player.dozing(NewFunction.none())).withProbation(Probation.of(Duration.ofMinutes(1))));
        player.device.canBeAsked = true;
        player.after = () -> {
            player.after = () -> {};
            throw new UnknownEffectException("play was not answered");
        };
        player.press("play");
        player.settle();
        assertThat(player.outcomes()).containsExactly("play FAILED", "in doubt HANDLED");
        assertThat(player.converter.knowledge().models()).isEqualTo(Player.MODELS);
        assertThat(player.states()).hasToString("(Playing, Playing)");
    }

    @Test
    void aRecordThatWasInDoubtOnProbationRollsBackHoweverSoonItIsCertainAgain() {
        player.acts("play");
        player.settle();
        player.converter.addListener(new ConverterListener() {
            @Override
            public void doubted(String why) {
                player.found();
            }
        });
        player.converter.evolve(
                Evolution.to(Player.dozing(NewFunction.none())).withProbation(Probation.of(Duration.ofMinutes(1))));
        player.before = () -> {
            player.before = () -> {};
            player.acts("play");
        };
        player.press("stop");
        player.settle();
        assertThat(player.outcomes()).contains("in doubt HANDLED").doesNotContain("stop FAILED");
        assertThat(player.converter.knowledge().models()).isEqualTo(Player.MODELS);
    }

    @Test
    void aRollbackThatIsNotPossibleInTimeIsGivenUp() {
        player.converter.evolve(
                Evolution.to(Player.dozing(NewFunction.none())).withProbation(Probation.of(Duration.ofMinutes(1))));
        player.after = () -> {
            player.after = () -> {};
            throw new UnknownEffectException("play was not answered");
        };
        player.press("play");
        player.settle();
        player.clock.advance(Evolution.USUAL_DEADLINE);
        player.settle();
        player.found();
        player.settle();
        assertThat(player.doubt()).isEmpty();
        assertThat(player.converter.knowledge().models().evolved().name()).isEqualTo("next");
    }

    @Test
    void aStateWithAnotherNameKeepsTheValuesOfTheEventThatLedToIt() {
        player.press("play");
        player.buttons.press("fade", Values.of("volume", 7));
        player.observe();
        player.settle();
        List<Values> seen = new ArrayList<>();
        player.converter.evolve(Evolution.to(Player.knowledge(
                        List.of("Softening"),
                        visit -> seen.add(visit.values()),
                        "Playing fade -> Softening",
                        "Softening faded -> Stopped",
                        "Softening stop -> Stopped"))
                .withMapping(Mapping.byName()
                        .withState(new State("Fading"), new State("Softening"))
                        .withFunction(new State("Fading"), false)));
        player.converter.stop();
        player.converter.start();
        assertThat(seen).containsExactly(Values.of("volume", 7), Values.of("volume", 7));
        player.converter.rollBack();
        assertThat(fadings).singleElement().extracting(Visit::values).isEqualTo(Values.of("volume", 7));
    }

    /** It waits behind the question to the device, which has reported meanwhile where it is. */
    @Test
    void anOvertakenEventThatWaitsBehindASettledDoubtKeepsOtherModelsFromTakingOver() {
        playAndFade();
        player.after = () -> {
            player.after = () -> {};
            player.acts("play");
        };
        player.press("stop");
        player.converter.step();
        assertThat(player.doubt()).isNotEmpty();
        player.found();
        assertThat(player.doubt()).isEmpty();
        assertThatThrownBy(() -> player.converter.evolve(Evolution.to(Player.dozing(NewFunction.none()))))
                .isInstanceOf(EvolutionException.class);
    }
}
