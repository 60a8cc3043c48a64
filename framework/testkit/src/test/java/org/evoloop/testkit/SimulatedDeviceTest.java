package org.evoloop.testkit;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.time.Duration;
import java.util.List;
import java.util.function.UnaryOperator;
import org.evoloop.converter.HistoryEntry;
import org.evoloop.converter.StateKnowledge;
import org.evoloop.evolution.ModelPair;
import org.evoloop.evolution.Outcome;
import org.evoloop.evolution.Source;
import org.evoloop.statemachine.StateMachine;
import org.junit.jupiter.api.Test;

/** A device made from a model behaves like real devices, including their faults. */
class SimulatedDeviceTest {
    private static SimulatedDevice device(UnaryOperator<SimulatedDevice.Builder> options) {
        return options.apply(SimulatedDevice.of(Models.PLAYER).buttons("play", "pause", "stop"))
                .build();
    }

    private static ConverterHarness converterOf(SimulatedDevice device) {
        return ConverterHarness.of(new StateKnowledge(Models.player()))
                .with(device)
                .start();
    }

    /** How the presses ended. */
    private static List<Outcome> outcomes(ConverterHarness converter) {
        return converter.history().stream()
                .filter(entry -> entry.occurrence().source() == Source.CONTROLLER)
                .map(HistoryEntry::outcome)
                .toList();
    }

    @Test
    void itObeysCommandsAndReportsWhatItDoesByItself() {
        SimulatedDevice player = device(options -> options);
        ConverterHarness converter = converterOf(player);
        converter.press("play").pressOnDevice("pause", true).expect("Paused", "Paused");
        converter.press("play").deviceDoes("ended").expect("Stopped", "Stopped");
        assertThat(player.received()).containsExactly("play", "play");
        assertThat(converter.sent()).isEqualTo(player.received());
    }

    @Test
    void aButtonThatMeansNothingWhereItIsDoesNothing() {
        SimulatedDevice player = device(options -> options);
        ConverterHarness converter = converterOf(player);
        assertThat(player.button("pause")).isFalse();
        converter.settle().expect("Stopped", "Stopped");
        assertThat(converter.history()).isEmpty();
        assertThatThrownBy(() -> converter.deviceDoes("ended"))
                .isInstanceOf(IllegalStateException.class)
                .hasMessage("the device, in Stopped, does not know ended");
    }

    @Test
    void aLostCommandOfADeviceThatAnswersLeavesTheRecordInDoubtUntilItIsFound() {
        SimulatedDevice player = device(options -> options);
        ConverterHarness converter = converterOf(player);
        player.incidents(IncidentPlan.at(1, Incident.lost()));
        converter.press("play");
        assertThat(outcomes(converter)).containsExactly(Outcome.FAILED);
        assertThat(converter.failures()).singleElement().asString().contains("the device does not answer play");
        assertThat(converter.status().doubt()).contains("it is unknown whether play had its effect");
        player.reportsState();
        assertThat(converter.settle().status().doubt()).isEmpty();
        converter.press("play").expect("Playing", "Playing");
    }

    @Test
    void aLostCommandOfASilentDeviceGoesUnnoticedUntilItIsFound() {
        SimulatedDevice player = device(SimulatedDevice.Builder::silent);
        ConverterHarness converter = converterOf(player);
        player.incidents(IncidentPlan.at(1, Incident.lost()));
        converter.press("play");
        assertThat(converter.states().original()).hasToString("Playing");
        assertThat(player.state()).isEqualTo("Stopped");
        assertThat(player.received()).isEmpty();

        player.reportsState();
        converter.settle().expect("Stopped", "Stopped");
    }

    @Test
    void aRefusedCommandHasNoEffectAndAnUnansweredOneHasIt() {
        SimulatedDevice player = device(options -> options);
        ConverterHarness converter = converterOf(player);
        player.incidents(IncidentPlan.at(1, Incident.refused()).and(IncidentPlan.at(2, Incident.unanswered())));
        converter.press("play");
        assertThat(player.state()).isEqualTo("Stopped");
        converter.press("play");
        assertThat(player.state()).isEqualTo("Playing");
        assertThat(outcomes(converter)).containsExactly(Outcome.FAILED, Outcome.FAILED);
        assertThat(converter.states().original()).hasToString("Stopped");
        assertThat(converter.status().doubt()).contains("it is unknown whether play had its effect");
    }

    @Test
    void whatItDoesWhileACommandIsBeingSentIsReportedInOrder() {
        SimulatedDevice player = device(options -> options);
        ConverterHarness converter = converterOf(player);
        player.incidents(IncidentPlan.at(2, Incident.before("stop")).and(IncidentPlan.at(3, Incident.after("pause"))));
        converter.press("play").press("pause");
        assertThat(player.received()).startsWith("play", "pause");
        converter.expect(player.state(), converter.states().evolved().name());
        while (player.commands() < 3) {
            converter.press("play");
        }
        converter.expect(player.state(), converter.states().evolved().name());
    }

    @Test
    void aSilentDeviceLeavesTheConverterInDoubtUnlessItCanBeAsked() {
        for (boolean canBeAsked : new boolean[] {false, true}) {
            SimulatedDevice player =
                    device(options -> canBeAsked ? options.silent().answersLocate() : options.silent());
            ConverterHarness converter = converterOf(player);
            player.incidents(IncidentPlan.at(2, Incident.after("play")));
            converter.press("play").press("stop");
            assertThat(converter.status().doubt().isEmpty()).isEqualTo(canBeAsked);
            // Once it has said that it plays, the press is carried out: it is stopped again.
            assertThat(player.state()).isEqualTo(canBeAsked ? "Stopped" : "Playing");
            assertThat(converter.states().original()).hasToString("Stopped");
        }
    }

    @Test
    void aCommandTakesItsTimeAndTheDeviceMayActMeanwhile() {
        SimulatedDevice player = device(
                options -> options.takesEffectAfter(Duration.ofMillis(100)).readyAfter(Duration.ofSeconds(1)));
        ConverterHarness converter = converterOf(player);
        player.actsAfter(Duration.ofMillis(50), "play");
        converter.press("play").expect("Playing", "Playing");
        assertThat(converter.clock().nanoTime()).isEqualTo(100_000_000L);
        assertThat(converter.history())
                .extracting(entry -> entry.occurrence().isFact())
                .containsExactly(false, true);

        converter.press("pause");
        assertThat(converter.clock().nanoTime())
                .as("ready a second after the first effect, plus a tenth to take effect")
                .isEqualTo(1_200_000_000L);
    }

    @Test
    void timeTriggersAreItsOwn() {
        StateMachine light = StateMachine.named("light")
                .initial("Off")
                .transition("Off", "press", "On")
                .transition("On", "tm(5s)", "Off")
                .build();
        SimulatedDevice device = SimulatedDevice.of(light).build();
        ConverterHarness converter = ConverterHarness.of(
                        new StateKnowledge(new ModelPair(light, light.withName("new"))))
                .with(device)
                .start();
        converter.press("press").expect("On", "On");
        converter.advance(Duration.ofSeconds(5)).expect("Off", "Off");
        assertThat(device.received()).containsExactly("press");
    }

    @Test
    void incidentsByChanceAreTheSameForTheSameSeed() {
        assertThat(storyOf(7)).isEqualTo(storyOf(7)).isNotEqualTo(storyOf(8));
    }

    /** If a device answers, its recorded state is always right, whatever happens to its commands. */
    private static String storyOf(long seed) {
        SimulatedDevice player = device(SimulatedDevice.Builder::answersLocate);
        ConverterHarness converter = converterOf(player);
        IncidentPlan plan = IncidentPlan.random(
                seed,
                0.5,
                Incident.lost(),
                Incident.refused(),
                Incident.unanswered(),
                Incident.before("stop"),
                Incident.after("play"));
        player.incidents(plan);
        for (int press = 0; press < 50; press++) {
            converter.press(press % 3 == 0 ? "pause" : press % 3 == 1 ? "play" : "stop");
            converter.expect(player.state(), converter.states().evolved().name());
        }
        assertThat(player)
                .hasToString(player.state() + ", received " + player.received() + ", incidents of seed " + seed);
        return player.received().toString();
    }

    @Test
    void aPlanThatCannotBeIsRefused() {
        assertThatThrownBy(() -> IncidentPlan.at(0, Incident.lost())).isInstanceOf(IllegalArgumentException.class);
        assertThatThrownBy(() -> IncidentPlan.random(1, 1.5, Incident.lost()))
                .hasMessageContaining("the probability is 1.5, allowed is 0 to 1");
        assertThatThrownBy(() -> device(options -> options).put("Nowhere"))
                .hasMessageStartingWith("the device has no state Nowhere; there is Paused, Playing, Stopped");
    }
}
