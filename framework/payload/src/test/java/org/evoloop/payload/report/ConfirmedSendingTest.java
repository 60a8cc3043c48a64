package org.evoloop.payload.report;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.time.Duration;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Consumer;
import org.evoloop.converter.UnknownEffectException;
import org.evoloop.evolution.Step;
import org.evoloop.payload.Meanings;
import org.evoloop.payload.Rest;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.State;
import org.evoloop.statemachine.Transition;
import org.evoloop.time.ManualClock;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/** What a report says of a command that was sent before it. */
@Timeout(60)
class ConfirmedSendingTest {
    private static final Duration LIMIT = Duration.ofSeconds(2);
    private static final Step SWITCH_ON = new Step(
            new Transition(new State("off"), new Event("switch"), new State("on")), new Event("switch"), false, false);

    private final ManualClock clock = new ManualClock();
    private final Lamp lamp = new Lamp();
    private final ConfirmedSending sending = new ConfirmedSending(lamp);
    private final List<String> effects = new ArrayList<>();

    /** A device whose reports the test gives. */
    private final class Lamp implements ReportingDevice {
        private final Map<String, Aftermath> aftermaths = new HashMap<>();
        private final List<Consumer<Report>> consumers = new ArrayList<>();
        private final List<Consumer<String>> losses = new ArrayList<>();
        private final Turns turns = new Turns();
        private boolean isUp = true;

        @Override
        public ManualClock clock() {
            return clock;
        }

        @Override
        public Turns turns() {
            return turns;
        }

        @Override
        public boolean isUp() {
            return isUp;
        }

        @Override
        public String describe() {
            return "the lamp is unplugged";
        }

        @Override
        public void subscribeFirst(String source, Consumer<Report> consumer) {
            consumers.add(consumer);
        }

        @Override
        public Aftermath aftermath(String source) {
            return aftermaths.computeIfAbsent(source, first -> new Aftermath(turns));
        }

        @Override
        public void onLost(Consumer<String> action) {
            losses.add(action);
        }

        void says(String state) {
            consumers.forEach(each -> each.accept(new Report(state, false)));
        }

        void isLost() {
            losses.forEach(each -> each.accept("the cable is out"));
        }
    }

    @BeforeEach
    void confirm() {
        Meanings states = Meanings.of(Map.of("0", "off", "1", "on"));
        sending.confirmedBy("lamp", states, LIMIT);
        sending.answeredBy("lamp", states);
    }

    @AfterEach
    void close() {
        clock.close();
    }

    private void send(Transmission how) throws Exception {
        sending.send(SWITCH_ON, "the switch", how, () -> effects.add("on"));
    }

    @Test
    void aStepIsOverWhenItsStateIsReported() throws Exception {
        send(pending -> {
            lamp.says("0");
            assertThat(effects).isEmpty();
            lamp.says("1");
            assertThat(effects).containsExactly("on");
            lamp.says("1");
        });
        assertThat(effects).containsExactly("on");
        assertThat(sending.isConfirmed()).isTrue();
    }

    @Test
    void withoutThatReportItsEffectIsUnknownAfterTheLimit() {
        assertThatThrownBy(() -> send(pending -> clock.advance(LIMIT)))
                .isInstanceOf(UnknownEffectException.class)
                .hasMessageContaining("the device has not reported within 2000 ms what became of the switch");
        assertThatThrownBy(() -> send(pending -> lamp.isLost()))
                .isInstanceOf(UnknownEffectException.class)
                .hasMessageContaining("the cable is out");
        assertThatThrownBy(() -> send(pending -> pending.fail("no answer")))
                .isInstanceOf(UnknownEffectException.class)
                .hasMessageContaining("no answer");
        assertThat(effects).isEmpty();
    }

    @Test
    void aRefusedStepHasNoEffect() {
        assertThatThrownBy(() -> send(pending -> pending.refuse("the child lock is on")))
                .isInstanceOf(IllegalStateException.class)
                .hasMessage("the child lock is on");
        assertThat(effects).isEmpty();
    }

    @Test
    void whatCouldNotBeSentHasNoEffect() {
        assertThatThrownBy(() -> send(pending -> {
                    throw new IOException("the cable is out");
                }))
                .isInstanceOf(IOException.class)
                .hasMessage("the cable is out");
        assertThat(effects).isEmpty();
    }

    @Test
    void noReportTellsOfAStepThatLeavesTheState() {
        State on = new State("on");
        Event set = new Event("set");
        assertThat(sending.isConfirmed(SWITCH_ON)).isTrue();
        assertThat(sending.isConfirmed(new Step(new Transition(on, set, on), set, false, false)))
                .isFalse();
    }

    @Test
    void aQuestionAfterAnUnknownStepTakesAnotherStateOnlyWhenItIsTooLateForItsEffect() throws Exception {
        assertThatThrownBy(() -> send(pending -> pending.fail("no answer"))).isInstanceOf(UnknownEffectException.class);

        String answer = sending.ask(
                "the question",
                pending -> {
                    lamp.says("0");
                    clock.advance(LIMIT);
                },
                LIMIT.multipliedBy(2));

        assertThat(answer).isEqualTo("off");
        assertThat(sending.ask(
                        "the question",
                        pending -> {
                            lamp.says("1");
                            clock.advance(Duration.ofMillis(1));
                        },
                        LIMIT))
                .isEqualTo("on");
    }

    @Test
    void aQuestionThatNobodyAnswersStaysOpen() {
        assertThatThrownBy(() -> sending.ask("the question", pending -> clock.advance(LIMIT), LIMIT))
                .isInstanceOf(UnknownEffectException.class)
                .hasMessageContaining("what became of the question");
    }

    @Test
    void nothingIsSentToADeviceThatCannotBeReached() {
        sending.requireUp("the switch");
        lamp.isUp = false;
        assertThatThrownBy(() -> sending.requireUp("the switch"))
                .isInstanceOf(IllegalStateException.class)
                .hasMessage("the lamp is unplugged; so the switch was not sent");
        assertThatThrownBy(() -> new ConfirmedSending(lamp).send(SWITCH_ON, "the switch", pending -> {}, () -> {}))
                .hasMessage("nothing confirms the switch");
    }

    @Test
    void aDeviceRestsAfterACommand() throws Exception {
        Rest rest = new Rest(clock, LIMIT);
        rest.await();
        rest.begin();
        clock.advance(LIMIT);
        rest.await();
        assertThat(clock.nanoTime()).isEqualTo(LIMIT.toNanos());
    }
}
