package org.evoloop.testkit;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.time.Duration;
import org.evoloop.LightBulb;
import org.evoloop.PaperModels;
import org.evoloop.RecordingExecute;
import org.evoloop.converter.HistoryEntry;
import org.evoloop.converter.PushMonitor;
import org.evoloop.converter.StateKnowledge;
import org.evoloop.evolution.ModelPair;
import org.evoloop.evolution.Outcome;
import org.evoloop.evolution.Values;
import org.evoloop.statemachine.StateMachine;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;

/** What a test sees of a converter, and the messages of failed expectations. */
class ConverterHarnessTest {
    private final SimulatedDevice device =
            SimulatedDevice.of(PaperModels.lightBulb().original()).build();
    private final ConverterHarness lamp =
            ConverterHarness.of(new LightBulb()).with(device).start();

    @AfterEach
    void close() {
        lamp.close();
    }

    @Test
    void aPressIsConvertedAtOnceAndTimePassesOnDemand() {
        lamp.press("switch").press("switch").expect("on", "wait");
        lamp.advance(Duration.ofMillis(1999)).expect("on", "wait");
        lamp.advance(Duration.ofMillis(1)).expect("off", "off");
        assertThat(lamp.sent()).containsExactly("switch", "switch");
        assertThat(lamp.clock().nanoTime()).isEqualTo(2_000_000_000L);
    }

    @Test
    void untilLetsAsMuchTimePassAsItTakes() {
        lamp.press("switch").press("switch").until("off").expect("off", "off");
        assertThat(lamp.clock().nanoTime()).isEqualTo(2_000_000_000L);
    }

    @Test
    void whatIsWantedAlreadyTakesNoTime() {
        lamp.until("off");
        assertThat(lamp.clock().nanoTime()).isZero();
    }

    @Test
    void aStateThatIsNeverReachedIsReportedWithAllThatIsKnown() {
        lamp.press("switch").press("switch").press("switch");
        assertThatThrownBy(() -> lamp.until("wait"))
                .isInstanceOf(AssertionError.class)
                .hasMessageContainingAll(
                        "the system never came to wait: nothing more is due",
                        "states: device on, system incandescentOn",
                        "truth: device on, received [switch]",
                        "queue: 0 waiting, room for 8 presses; 0 lost, 0 refused",
                        "time: 0.000 s of the clock; nothing is due",
                        "switch (controller): HANDLED, device on, system wait -> device on, system incandescentOn",
                        "transcript, last 14 of",
                        "\n     new_current_state: incandescentOn");
    }

    @Test
    void aStateThatComesTooLateIsNotWaitedFor() {
        lamp.press("switch").press("switch");
        assertThatThrownBy(() -> lamp.until("off", Duration.ofSeconds(1)))
                .isInstanceOf(AssertionError.class)
                .hasMessageContaining("the system did not come to off within PT1S")
                .hasMessageContaining("next is due in 2.000 s");
        assertThat(lamp.clock().nanoTime()).isZero();
    }

    @Test
    void aStateThatDoesNotExistIsTheTestsMistake() {
        assertThatThrownBy(() -> lamp.until("wiat"))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessage("the new model has no state wiat; did you mean wait?");
    }

    @Test
    void anEventThatDoesNotExistIsTheTestsMistake() {
        assertThatThrownBy(() -> lamp.press("swich")).isInstanceOf(IllegalArgumentException.class);
        assertThatThrownBy(() -> lamp.press("swich", Values.NONE))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessage("unknown event swich; did you mean switch?");
    }

    @Test
    void aStoppedConverterRefusesAnEventWithValuesToo() {
        lamp.converter().stop();
        assertThatThrownBy(() -> lamp.press("switch", Values.of("brightness", 1)))
                .isInstanceOf(IllegalStateException.class)
                .hasMessageContaining("is stopped");
    }

    @Test
    void expectLooksAtTheTruthToo() {
        device.put("on");
        assertThatThrownBy(() -> lamp.expect("off", "off"))
                .isInstanceOf(AssertionError.class)
                .hasMessageContainingAll("expected is device off, system off", "truth: device on");
        lamp.found("on").expect("on", "on");
    }

    @Test
    void theTranscriptIsThatOfThisConverterAlone() {
        try (ConverterHarness other = ConverterHarness.of(new LightBulb())
                .with(SimulatedDevice.of(PaperModels.lightBulb().original()).build())
                .start()) {
            other.press("switch");
            assertThat(lamp.transcript()).isEmpty();
            assertThat(other.transcript())
                    .contains("----   button_event : switch   -----", " switch command", " new_current_state: on");
        }
    }

    @Test
    void aTimerThatATimerStartsIsDueAtItsOwnTime() {
        lamp.press("switch");
        lamp.clock().schedule(Duration.ofSeconds(1), () -> lamp.press("switch"));
        lamp.advance(Duration.ofSeconds(10)).expect("off", "off");
        HistoryEntry last = lamp.history().get(lamp.history().size() - 1);
        assertThat(last.at().toEpochMilli()).isEqualTo(3000);
        assertThat(lamp.clock().nanoTime()).isEqualTo(10_000_000_000L);
    }

    @Test
    void eventsWithoutEndAreAnErrorAndNoEndlessTest() {
        PushMonitor restless = new PushMonitor("Restless") {};
        StateKnowledge knowledge = new LightBulb();
        try (ConverterHarness busy = ConverterHarness.of(knowledge)
                .with(SimulatedDevice.of(PaperModels.lightBulb().original()).build())
                .with(restless)
                .start()) {
            busy.converter().addListener(new org.evoloop.converter.ConverterListener() {
                @Override
                public void ended(HistoryEntry entry) {
                    restless.press("switch");
                }
            });
            assertThatThrownBy(() -> busy.press("switch"))
                    .isInstanceOf(AssertionError.class)
                    .hasMessageContaining("the converter does not come to rest");
        }
    }

    @Test
    void aTimerThatFiresAgainAndAgainIsNoReasonToGiveUp() {
        int[] ticks = new int[1];
        tick(ticks);
        lamp.advance(Duration.ofHours(2));
        assertThat(ticks[0]).isEqualTo(7201);
    }

    private void tick(int[] ticks) {
        ticks[0]++;
        lamp.clock().schedule(Duration.ofSeconds(1), () -> tick(ticks));
    }

    @Test
    void timersWithoutDelayThatFollowFromEachOtherAreAnError() {
        StateMachine light = StateMachine.named("light")
                .initial("Off")
                .transition("Off", "press", "On")
                .build();
        StateMachine restless = StateMachine.named("restless")
                .initial("Off")
                .transition("Off", "press", "On")
                .transition("On", "tm(0s)", "Tick")
                .transition("Tick", "tm(0s)", "On")
                .build();
        ConverterHarness converter = ConverterHarness.of(new StateKnowledge(new ModelPair(light, restless)))
                .with(SimulatedDevice.of(light).build())
                .start();
        converter.press("press");
        assertThatThrownBy(() -> converter.advance(Duration.ofSeconds(1)))
                .isInstanceOf(AssertionError.class)
                .hasMessageContaining("timers without delay");
    }

    @Test
    void withoutASimulatedDeviceTheHarnessReportsWhatItDoes() {
        try (ConverterHarness robot = ConverterHarness.of(new StateKnowledge(Models.player()))
                .with(new RecordingExecute("Device", "play", "pause", "stop"))
                .start()) {
            robot.press("play").deviceDoes("ended").expect("Stopped", "Stopped");
            robot.found("Paused").expect("Paused", "Paused");
            assertThat(robot.history().get(1).outcome()).isEqualTo(Outcome.HANDLED);
            assertThat(robot.failures()).isEmpty();
        }
    }
}
